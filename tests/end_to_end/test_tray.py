# SPDX-License-Identifier: MIT
"""The tray's menu and a pet's own, through real X events: every entry does what it says.

Usage: test_tray.py hyrax.exe [--openings N] [--picture FILE]
"""

import json
import re
import sys
import time
import unittest
from pathlib import Path

import desktop
from daemon import FUR, Daemon

EXE = PICTURE = None
OPENINGS = 50  # the long form of the soak takes 1000

MONITORS = [(1280, 720, 0, 0), (800, 600, 1280, 0)]
FLOATING = {"physics": {"gravity": 0, "air_drag": 1}}


def start(x, y, **pet):
    return {"pets": {"start": [{"x": x, "y": y, **pet}], "drowsy_after": 60}}


class Tray(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.desk = cls.enterClassContext(desktop.VirtualDesktop(MONITORS, wallpaper="#204060"))

    def daemon(self, config, **options):
        daemon = Daemon(self.desk, EXE, config, **options)
        self.addCleanup(daemon.end)
        return daemon

    def open_menu(self, x=None, y=None):
        """By a right click there, without a place on the tray's icon."""
        if x is None:
            (tray,) = self.desk.windows("Wine System Tray")
            x, y = tray.x + 10, tray.y + 10

        self.desk.click(x, y, button=3)
        return desktop.wait_for(self.menus, 10, "the menu")[0]

    def choose(self, *keys):
        """Opens the tray's menu and types the mnemonics of an entry."""
        menu = self.open_menu()
        for key in keys:
            time.sleep(0.1)
            self.desk.key(key)
        desktop.wait_for(lambda: not self.desk.is_viewable(menu), 10, "the menu to close")

    def state(self, daemon):
        try:
            return json.loads((daemon.profile / "state.json").read_text())
        except FileNotFoundError:
            return {}

    def wait_for_state(self, daemon, key, value):
        desktop.wait_for(
            lambda: self.state(daemon).get(key) == value, 10, f"{key} to be {value} in {self.state(daemon)}"
        )

    def windows(self):
        while True:
            try:
                return self.desk.windows("^hyrax.exe$")
            except RuntimeError:
                time.sleep(0.05)  # one went while they were listed

    def menus(self):
        """Open menus and submenus: hyrax's windows without a name."""
        return [w for w in self.windows() if w.name == ""]

    def panes(self):
        return [w for w in self.windows() if w.name != ""]

    def quit(self, daemon):
        self.choose("q")
        self.assertEqual(daemon.program.wait(10), 0)

    def test_spawn_fling_reset_remove_and_pause(self):
        daemon = self.daemon(start(300, 300))
        daemon.wait_for_rest()
        self.choose("s", "h")
        daemon.wait_for_rest(2)
        self.choose("f")
        daemon.wait_for_pets(lambda pets: all(pet["motion"] == "airborne" for pet in pets), 10, "all to fly")
        self.choose("p")
        time.sleep(1.0)
        frozen = daemon.pets()
        time.sleep(1.0)
        self.assertEqual([(p["x"], p["y"]) for p in daemon.pets()], [(p["x"], p["y"]) for p in frozen])
        self.choose("p")
        self.choose("r")
        daemon.wait_for_pets(lambda pets: 300 in [pet["x"] for pet in pets], 10, "the first one to go back")
        self.choose("m")
        desktop.wait_for(lambda: not self.panes(), 10, "all to go")
        self.quit(daemon)

    def test_gather_calls_pets_to_the_monitor_under_the_pointer(self):
        daemon = self.daemon(start(1700, 300))
        daemon.wait_for_rest()
        self.choose("g")
        daemon.wait_for_pets(lambda pets: pets[0]["x"] < 1280, 10, "the pet to come")
        self.desk.move(1600, 200)
        # Wine asks X for the pointer once the last change that it knows of is 100 ms old.
        time.sleep(0.3)
        self.assertEqual(daemon.second_start("--gather"), 0)
        daemon.wait_for_pets(lambda pets: pets[0]["x"] > 1280, 10, f"the pet to come to {self.desk.pointer()}")
        self.quit(daemon)

    def test_hidden_pets_have_no_window_and_wake_nothing(self):
        daemon = self.daemon({**FLOATING, **start(100, 300, vx=30)})
        daemon.wait_for_pets(lambda pets: pets and pets[0]["x"] > 105, 20, "the pet to drift")
        self.choose("h", "3")
        desktop.wait_for(lambda: not self.panes(), 10, "the pane to go")
        self.wait_for_state(daemon, "hidden", True)
        until = self.state(daemon)["hidden_until"]
        self.assertAlmostEqual(until, time.time() + 1800, delta=30)
        time.sleep(1.0)
        before = {thread.id: thread.wakeups for thread in daemon.program.threads()}
        hidden_at = daemon.pets()[0]["x"]
        time.sleep(5)
        woken = sum(t.wakeups - before.get(t.id, 0) for t in daemon.program.threads())
        self.assertLessEqual(woken, 2)
        self.choose("h")  # now it says Show
        desktop.wait_for(self.panes, 10, "the pane to come back")
        daemon.wait_for_pets(lambda pets: pets[0]["x"] > hidden_at + 5, 10, "the pet to drift on")
        for keys in (("h", "t"), ("h", "s")):
            self.choose(*keys)
            desktop.wait_for(lambda: not self.panes(), 10, "the pane to go")
            self.assertEqual(daemon.second_start("--show"), 0)
            desktop.wait_for(self.panes, 10, "the pane to come back")
        self.quit(daemon)

    def test_quiet_holds_scripts_back(self):
        script = "hyrax.every(0.2, function() hyrax.spawn{} end)"
        daemon = self.daemon({"pets": {"start": []}}, scripts={"spawn.lua": script}, arguments=("--quiet", "on"))
        daemon.wait_for_log("spawn: refused while hyrax is quiet")
        self.assertEqual(daemon.rows(), [])
        self.choose("e")
        daemon.wait_for_pets(lambda pets: len(pets) > 2, 10, "pets to come")
        self.choose("e")
        self.wait_for_state(daemon, "quiet", True)
        self.quit(daemon)

    def test_scripts_and_monitors_are_switched_and_remembered(self):
        daemon = self.daemon(start(1700, 300), scripts={"a.lua": "hyrax.log.info('hello from a')"})
        daemon.wait_for_rest()
        self.choose("c", "a")
        self.wait_for_state(daemon, "scripts_off", ["a.lua"])
        self.choose("c", "a")
        self.wait_for_state(daemon, "scripts_off", [])
        self.choose("c", "r")
        desktop.wait_for(lambda: daemon.log_text().count("hello from a") >= 3, 10, "the script to start again")
        self.choose("n", "2")
        daemon.wait_for_pets(lambda pets: pets[0]["x"] < 1280, 10, "the pet to leave the second monitor")
        self.assertEqual(list(self.state(daemon)["monitors"].values()), [False])
        self.choose("n", "2")
        self.wait_for_state(daemon, "monitors", {})
        self.quit(daemon)

    def test_open_about_and_autostart(self):
        daemon = self.daemon(start(300, 300))
        daemon.wait_for_rest()
        self.choose("a")
        (about,) = desktop.wait_for(lambda: self.desk.windows("^About hyrax$"), 10, "the about box")
        if PICTURE:
            time.sleep(1.0)
            self.desk.screenshot(PICTURE.with_suffix(".about.png"))
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
        self.assertEqual(daemon.second_start("--quit"), 0)
        self.assertEqual(daemon.program.wait(10), 0)

    def test_arrow_keys_and_a_submenu(self):
        daemon = self.daemon({**FLOATING, **start(300, 300, vx=20)})
        daemon.wait_for_pets(lambda pets: len(pets) == 1, 20)
        self.open_menu()
        self.desk.key("Down")
        time.sleep(0.2)
        self.desk.key("Right")
        desktop.wait_for(lambda: len(self.menus()) == 2, 10, "the submenu")
        time.sleep(0.5)
        before = daemon.pets()[0]["x"]
        if PICTURE:
            self.desk.screenshot(PICTURE)
        time.sleep(2.0)
        self.assertGreater(daemon.pets()[0]["x"], before + 25)  # the open submenu holds nobody up
        self.desk.key("Return")
        daemon.wait_for_pets(lambda pets: len(pets) == 2, 10, "the second pet")
        self.quit(daemon)

    def test_a_pets_own_menu(self):
        daemon = self.daemon(start(300, 300))
        (pet,) = daemon.wait_for_rest()

        def open_pet_menu(pet):
            return self.open_menu(pet["x"] + FUR[0], pet["y"] + FUR[1])

        menu = open_pet_menu(pet)
        self.desk.key("Escape")
        desktop.wait_for(lambda: not self.desk.is_viewable(menu), 10, "the menu to close")
        self.assertEqual(len(daemon.pets()), 1)
        self.assertEqual(daemon.second_start("--spawn", "2"), 0)
        pets = daemon.wait_for_rest(3)
        open_pet_menu(pets[0])
        self.desk.key("o")
        daemon.wait_for_pets(lambda now: len(now) == 1, 10, "the others to go")
        (last,) = daemon.wait_for_rest()
        time.sleep(1.0)  # until the pane has shrunk to the one that is left
        open_pet_menu(last)
        self.desk.key("m")
        desktop.wait_for(lambda: not self.panes(), 10, "the last one to go")
        self.quit(daemon)

    def test_menus_leave_nothing_behind(self):
        daemon = self.daemon(start(300, 300))
        daemon.wait_for_rest()

        def files():
            return len(list(Path(f"/proc/{daemon.program.pid}/fd").iterdir()))

        def memory():
            status = Path(f"/proc/{daemon.program.pid}/status").read_text()
            return int(re.search(r"VmRSS:\s+(\d+)", status)[1])

        def open_and_close(times):
            for _ in range(times):
                menu = self.open_menu()
                self.desk.key("Escape")
                desktop.wait_for(lambda: not self.desk.is_viewable(menu), 10, "the menu to close")

        open_and_close(10)
        files_before, memory_before = files(), memory()
        open_and_close(OPENINGS)
        print(f"{OPENINGS} menus: files {files_before} -> {files()}, memory {memory_before} -> {memory()} kB")
        self.assertLessEqual(files(), files_before + 2)
        self.assertLess(memory(), memory_before + 2048)
        self.quit(daemon)


if __name__ == "__main__":
    EXE = Path(sys.argv[1]).resolve()
    del sys.argv[1]
    for option in ("--openings", "--picture"):
        if option in sys.argv:
            at = sys.argv.index(option)
            value = sys.argv[at + 1]
            del sys.argv[at : at + 2]
            if option == "--openings":
                OPENINGS = int(value)
            else:
                PICTURE = Path(value)
    unittest.main(verbosity=2)
