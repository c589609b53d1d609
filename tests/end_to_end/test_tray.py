# SPDX-License-Identifier: MIT
"""The tray's menu and a pet's own, through real X events: every entry does what it says.

Usage: test_tray.py hyrax.exe [--openings N] [--picture FILE]
"""

import argparse
import re
import sys
import time
from pathlib import Path

import desktop
import fixture
from daemon import FLOATING, grip, pets_at
from program import footprint

OPTIONS = None


class Tray(fixture.OnDesktop):
    MONITORS = [(1280, 720, 0, 0), (800, 600, 1280, 0)]

    def choose(self, *keys):
        """Opens the tray's menu and types the mnemonics of an entry."""
        menu = self.open_menu()
        for key in keys:
            time.sleep(0.1)
            self.desk.key(key)
        desktop.wait_for(lambda: not self.desk.is_viewable(menu), 10, "the menu to close")

    def quit_by_menu(self, daemon):
        self.choose("q")
        self.assertEqual(daemon.program.wait(10), 0)

    def test_spawn_fling_reset_remove_and_pause(self):
        daemon = self.daemon(pets_at((300, 300)))
        daemon.wait_for_rest()
        self.choose("s", "h")
        daemon.wait_for_rest(2)
        self.choose("f")
        daemon.wait_for_pets(lambda pets: all(pet["motion"] == "airborne" for pet in pets), 10, "all to fly")
        self.choose("p")
        time.sleep(1.0)
        self.assert_still(daemon)
        self.choose("p")
        self.choose("r")
        daemon.wait_for_pets(lambda pets: 300 in [pet["x"] for pet in pets], 10, "the first one to go back")
        self.choose("m")
        desktop.wait_for(lambda: not self.panes(), 10, "all to go")
        self.quit_by_menu(daemon)

    def test_gather_calls_pets_to_the_monitor_under_the_pointer(self):
        daemon = self.daemon(pets_at((1700, 300)))
        daemon.wait_for_rest()
        self.choose("g")
        daemon.wait_for_pets(lambda pets: pets[0]["x"] < 1280, 10, "the pet to come")
        self.desk.move(1600, 200)
        # Wine asks X for the pointer once the last change that it knows of is 100 ms old.
        time.sleep(0.3)
        self.assertEqual(daemon.second_start("--gather"), 0)
        daemon.wait_for_pets(lambda pets: pets[0]["x"] > 1280, 10, f"the pet to come to {self.desk.pointer()}")
        self.quit_by_menu(daemon)

    def test_hidden_pets_have_no_window_and_wake_nothing(self):
        daemon = self.daemon({**FLOATING, **pets_at((100, 300), vx=30)})
        daemon.wait_for_pets(lambda pets: pets and pets[0]["x"] > 105, 20, "the pet to drift")
        self.choose("h", "3")
        desktop.wait_for(lambda: not self.panes(), 10, "the pane to go")
        daemon.wait_for_state("hidden", True)
        until = daemon.state()["hidden_until"]
        self.assertAlmostEqual(until, time.time() + 1800, delta=30)
        time.sleep(1.0)
        before = daemon.program.wakeups()
        hidden_at = daemon.pets()[0]["x"]
        time.sleep(5)
        self.assertLessEqual(daemon.program.woken_since(before), 2)
        self.choose("h")  # now it says Show
        desktop.wait_for(self.panes, 10, "the pane to come back")
        daemon.wait_for_pets(lambda pets: pets[0]["x"] > hidden_at + 5, 10, "the pet to drift on")
        for keys in (("h", "t"), ("h", "s")):
            self.choose(*keys)
            desktop.wait_for(lambda: not self.panes(), 10, "the pane to go")
            self.assertEqual(daemon.second_start("--show"), 0)
            desktop.wait_for(self.panes, 10, "the pane to come back")
        self.quit_by_menu(daemon)

    def test_quiet_holds_scripts_back(self):
        script = "hyrax.every(0.2, function() hyrax.spawn{} end)"
        daemon = self.daemon(pets_at(), scripts={"spawn.lua": script}, arguments=("--quiet", "on"))
        daemon.wait_for_log("spawn: refused while hyrax is quiet")
        self.assertEqual(daemon.rows(), [])
        self.choose("e")
        daemon.wait_for_pets(lambda pets: len(pets) > 2, 10, "pets to come")
        self.choose("e")
        daemon.wait_for_state("quiet", True)
        self.quit_by_menu(daemon)

    def test_scripts_and_monitors_are_switched_and_remembered(self):
        daemon = self.daemon(pets_at((1700, 300)), scripts={"a.lua": "hyrax.log.info('hello from a')"})
        daemon.wait_for_rest()
        self.choose("c", "a")
        daemon.wait_for_state("scripts_off", ["a.lua"])
        self.choose("c", "a")
        daemon.wait_for_state("scripts_off", [])
        self.choose("c", "r")
        desktop.wait_for(lambda: daemon.log_text().count("hello from a") >= 3, 10, "the script to start again")
        self.choose("n", "2")
        daemon.wait_for_pets(lambda pets: pets[0]["x"] < 1280, 10, "the pet to leave the second monitor")
        self.assertEqual(list(daemon.state()["monitors"].values()), [False])
        self.choose("n", "2")
        daemon.wait_for_state("monitors", {})
        self.quit_by_menu(daemon)

    def test_open_about_and_autostart(self):
        daemon = self.daemon(pets_at((300, 300)))
        daemon.wait_for_rest()
        self.choose("a")
        (about,) = desktop.wait_for(lambda: self.desk.windows("^About hyrax$"), 10, "the about box")
        if OPTIONS.picture:
            time.sleep(1.0)
            self.desk.screenshot(OPTIONS.picture.with_suffix(".about.png"))
        # Without a window manager nobody gives it the keyboard: the OK button, at the bottom right.
        self.desk.click(about.x + about.width - 60, about.y + about.height - 24)
        desktop.wait_for(lambda: not self.desk.is_viewable(about), 10, "the about box to close")

        def entry():
            query = self.desk.start("reg", "query", r"HKCU\Software\Microsoft\Windows\CurrentVersion\Run", "/v", "hyrax")
            query.wait()
            return query.text()

        self.assertNotIn("--autostart", entry())
        self.choose("w")
        desktop.wait_for(lambda: re.search(r'"[^"]*hyrax\.exe" --autostart', entry()), 20, "the entry")
        self.choose("w")
        desktop.wait_for(lambda: "--autostart" not in entry(), 20, "the entry to go")
        self.choose("o", "l")  # the last one: the editor covers the tray
        desktop.wait_for(lambda: self.desk.windows("hyrax.log"), 30, "the log in an editor")
        self.quit(daemon)

    def test_arrow_keys_and_a_submenu(self):
        daemon = self.daemon({**FLOATING, **pets_at((300, 300), vx=20)})
        daemon.wait_for_pets(lambda pets: len(pets) == 1, 20)
        self.open_menu()
        self.desk.key("Down")
        time.sleep(0.2)
        self.desk.key("Right")
        desktop.wait_for(lambda: len(self.menus()) == 2, 10, "the submenu")
        time.sleep(0.5)
        before = daemon.pets()[0]["x"]
        if OPTIONS.picture:
            self.desk.screenshot(OPTIONS.picture)
        time.sleep(2.0)
        self.assertGreater(daemon.pets()[0]["x"], before + 25)  # the open submenu holds nobody up
        self.desk.key("Return")
        daemon.wait_for_pets(lambda pets: len(pets) == 2, 10, "the second pet")
        self.quit_by_menu(daemon)

    def test_a_pets_own_menu(self):
        daemon = self.daemon(pets_at((300, 300)))
        (pet,) = daemon.wait_for_rest()
        menu = self.open_menu(*grip(pet))
        self.desk.key("Escape")
        desktop.wait_for(lambda: not self.desk.is_viewable(menu), 10, "the menu to close")
        self.assertEqual(len(daemon.pets()), 1)
        self.assertEqual(daemon.second_start("--spawn", "2"), 0)
        pets = daemon.wait_for_rest(3)
        self.open_menu(*grip(pets[0]))
        self.desk.key("o")
        daemon.wait_for_pets(lambda now: len(now) == 1, 10, "the others to go")
        (last,) = daemon.wait_for_rest()
        time.sleep(1.0)  # until the pane has shrunk to the one that is left
        self.open_menu(*grip(last))
        self.desk.key("m")
        desktop.wait_for(lambda: not self.panes(), 10, "the last one to go")
        self.quit_by_menu(daemon)

    def test_menus_leave_nothing_behind(self):
        daemon = self.daemon(pets_at((300, 300)))
        daemon.wait_for_rest()

        def open_and_close(times):
            for _ in range(times):
                menu = self.open_menu()
                self.desk.key("Escape")
                desktop.wait_for(lambda: not self.desk.is_viewable(menu), 10, "the menu to close")

        open_and_close(10)
        before = footprint(daemon.program.pid)
        open_and_close(OPTIONS.openings)
        after = footprint(daemon.program.pid)
        print(f"{OPTIONS.openings} menus: {before} before, {after} after")
        self.assertLessEqual(after["descriptors"], before["descriptors"] + 2)
        self.assertLess(after["resident"], before["resident"] + (2 << 20))
        self.quit_by_menu(daemon)


if __name__ == "__main__":
    options = argparse.ArgumentParser(add_help=False, allow_abbrev=False)
    options.add_argument("--openings", type=int, default=50)  # the long form of the soak takes 1000
    options.add_argument("--picture", type=Path)
    OPTIONS, sys.argv[1:] = options.parse_known_args()
    fixture.main("hyrax")
