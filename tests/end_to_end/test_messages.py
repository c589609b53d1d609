# SPDX-License-Identifier: MIT
"""What the system tells hyrax.exe while all its pets rest, under Wine.

Usage: test_messages.py hyrax.exe policy_probe.exe
"""

import json
import os
import signal
import time

import desktop
import fixture
from daemon import FUR, around, grip, pets_at
from policy_probe import SCREENS, TEST_FACT, WIDER, BesidePrograms

MONITORS = BesidePrograms.MONITORS
WM_CAPTURECHANGED = 0x215
TRAY_MESSAGE = 0x8000 + 1
NIN_KEYSELECT = 0x401


class Messages(BesidePrograms):
    def at_rest(self, *places, overlay=None, **options):
        """A daemon whose pets have come to rest, and whose panes have shrunk to them."""
        daemon = self.daemon({**pets_at(*places, drowsy_after=0), "overlay": overlay or {}}, **options)
        daemon.wait_for_rest(len(places))
        time.sleep(1.5)
        return daemon

    def picture_of(self, pet):
        return self.desk.screenshot().crop(*around(pet, margin=10))

    def still_picture_of(self, pet):
        """Once two of them, half a second apart, are the same: a busy X server is late."""
        pictures = [self.picture_of(pet)]

        def same():
            time.sleep(0.5)
            pictures.append(self.picture_of(pet))
            return pictures[-1].changed_box(pictures[-2]) is None

        desktop.wait_for(same, 20, "a picture that stays")
        return pictures[-1]

    def test_a_pet_stays_seen_when_its_screen_becomes_wider(self):
        script = 'hyrax.on("monitors", function() print("screens changed") end) print("ready")'
        daemon = self.at_rest((500, 600), overlay={"reduced_motion": "on"}, scripts={"screens.lua": script})
        daemon.wait_for_log("screens.lua: ready")
        (pet,) = daemon.pets()
        before = self.still_picture_of(pet)
        panes = self.desk.windows("hyrax pane")
        for changes, wider in enumerate((200, 0), 1):
            self.tell(WIDER, wider)
            told = lambda: daemon.log_text().count("screens changed") >= changes
            desktop.wait_for(told, 10, "the change of screens")
            as_before = lambda: self.picture_of(pet).changed_box(before) is None
            told = lambda: (
                f"the pet to be seen as before, after {changes} changes; otherwise now: "
                f"{self.picture_of(pet).changed_box(before)}; was {pet}, is {daemon.pets()}"
            )
            desktop.wait_for(as_before, 10, told)
            time.sleep(0.5)
            self.assertEqual(self.desk.windows("hyrax pane"), panes)
            self.assertTrue(as_before())

    def test_a_new_front_window_is_heard_of(self):
        self.at_rest((500, 600))
        player = self.full_screen_on(MONITORS[0])
        desktop.wait_for(lambda: not self.panes(), 2, "the pane to go")
        player.end()
        desktop.wait_for(self.panes, 10, "the pane to come back")

    def test_panes_that_are_no_longer_on_top_come_back(self):
        self.at_rest((500, 600))
        self.ready_probe("lower")
        desktop.wait_for(lambda: " topmost 1 " in self.ask("panes"), 3, "the pane on top")

    def test_a_thousand_messages_hide_none(self):
        daemon = self.at_rest((500, 600), (1600, 700))
        os.kill(daemon.program.pid, signal.SIGSTOP)
        try:
            self.assertIn("posted 1001", self.ask("flood", TEST_FACT, SCREENS, 1))
        finally:
            os.kill(daemon.program.pid, signal.SIGCONT)
        # A changed screen counts when it was seen twice.
        on_the_first = lambda: all(row["x"] <= MONITORS[0][0] for row in daemon.pets())
        desktop.wait_for(on_the_first, 2, "all pets on the first screen")

    def test_another_window_takes_the_pointer_from_a_drag(self):
        daemon = self.at_rest((500, 600))
        (pet,) = daemon.pets()
        x, y = grip(pet)
        self.desk.drag([(x, y), (x + 100, 300)], release=False)
        daemon.wait_for_grab()
        self.send(WM_CAPTURECHANGED, 0, 1)
        daemon.wait_for_pets(lambda pets: pets[0]["motion"] != "held", 10, "the fall")
        # Neither moves nor the release concern the pet any more.
        self.desk.move(x - 300, 200)
        self.desk.release()
        (pet,) = daemon.wait_for_rest()
        self.assertAlmostEqual(pet["x"] + FUR[0], x + 100, delta=30)

    def test_a_pet_above_and_left_of_the_primary_screen_is_seen_and_grabbed(self):
        left, top = MONITORS[1][2:]
        place = (left + 60, top + 10)
        config = {"physics": {"gravity": 0, "rest_threshold": 50}, **pets_at(place, drowsy_after=0)}
        before = self.desk.screenshot()
        daemon = self.daemon(config)
        (pet,) = daemon.wait_for_pets(lambda pets: len(pets) == 1)
        self.assertLess(pet["x"], 0)
        self.assertLess(pet["y"] + FUR[1], 0)
        x, y = (int(at) for at in grip(pet))
        seen = lambda x, y: self.desk.screenshot()[x, y] != before[x, y]
        desktop.wait_for(lambda: seen(x, y), 10, "the pet in the picture")
        self.desk.carry([(x, y), (x + 80, y + 15)], release=False)
        daemon.wait_for_grab()
        desktop.wait_for(lambda: abs(daemon.pets()[0]["x"] - pet["x"] - 80) <= 1, 10, "the pet in the hand")
        desktop.wait_for(lambda: seen(x + 80, y + 15), 10, "the pet in the picture")
        self.desk.release()

    def test_a_new_taskbar_gets_the_icon_and_its_keys_open_the_menu(self):
        self.at_rest((500, 600))
        icons = lambda: self.desk.windows("Wine System Tray")
        self.assertEqual(len(icons()), 1)
        place = (icons()[0].x, icons()[0].width)
        self.send("TaskbarCreated")
        time.sleep(1.0)
        self.assertEqual((icons()[0].x, icons()[0].width), place)  # no second one beside it
        x, y = 640, 300
        self.send(TRAY_MESSAGE, x | y << 16, NIN_KEYSELECT | 1 << 16)
        (menu,) = desktop.wait_for(self.menus, 10, "the menu")
        corners = [(menu.x, menu.y), (menu.x, menu.y + menu.height)]
        self.assertLess(min(abs(a - x) + abs(b - y) for a, b in corners), 20, corners)
        self.desk.click(20, 20)
        desktop.wait_for(lambda: not self.menus(), 10, "the menu to close")
        self.open_menu()
        self.desk.key("Escape")

    def test_what_scripts_keep_is_kept_when_the_session_ends(self):
        script = 'hyrax.on("unload", function() hyrax.store.set("kept", "yes") end) print("ready")'
        daemon = self.daemon(pets_at(), scripts={"keep.lua": script})
        daemon.wait_for_log("keep.lua: ready")
        self.assertIn("answer 1", self.ask("end_session"))
        kept = json.loads((daemon.profile / "store" / "keep.lua.json").read_text())
        self.assertIn("yes", json.dumps(kept))


if __name__ == "__main__":
    fixture.main("hyrax", "probe")
