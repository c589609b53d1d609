# SPDX-License-Identifier: MIT
"""hyraxctl.exe against hyrax.exe under Wine, through the real pipe.

Usage: test_control.py hyrax.exe hyraxctl.exe
"""

import json
import sys
import time
import unittest
from pathlib import Path

import desktop
from daemon import Daemon, windows_path

EXE = CTL = None

FLOATING = {
    "physics": {"gravity": 0, "air_drag": 1, "restitution": 1},
    "pets": {"start": [{"x": 300, "y": 300, "vx": 60, "vy": 20}]},
}


class Control(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.desk = cls.enterClassContext(desktop.VirtualDesktop())

    def setUp(self):
        self.daemon = Daemon(self.desk, EXE, FLOATING)
        self.addCleanup(self.daemon.end)

    def start(self, *arguments):
        return self.desk.start(CTL, "--profile", windows_path(self.daemon.profile), "--json", *map(str, arguments))

    def ctl(self, *arguments, code=0):
        program = self.start(*arguments)
        self.assertEqual(program.wait(60), code, program.text())
        return program.text()

    def result(self, *arguments):
        return json.loads(self.ctl(*arguments))["result"]

    def error(self, *arguments):
        return json.loads(self.ctl(*arguments, code=1))["error"]["code"]

    def test_every_verb(self):
        (pet,) = self.result("spawn", "--x", 50, "--y", 60, "--tag", "party")["pets"]
        self.assertEqual(self.result("list", "--tag", "party")["pets"][0]["id"], pet)
        self.assertEqual(self.result("fling", pet, "--vx", 300, "--vy", -70), {"pets": 1})
        self.assertGreater(self.result("list", pet)["pets"][0]["x"], 50)
        self.assertEqual(self.result("stop", pet), {"pets": 1})
        self.assertEqual(self.result("reset", pet), {"pets": 1})
        self.assertEqual(self.result("list", pet)["pets"][0]["x"], 50)
        self.assertEqual(self.result("remove", pet), {"pets": 1})
        self.assertEqual(self.error("stop", pet), "no_such_pet")
        self.assertEqual(self.result("pause"), {"paused": True})
        self.assertTrue(self.result("status")["paused"])
        self.assertEqual(self.result("resume"), {"paused": False})
        self.assertEqual(self.result("scripts"), {"scripts": []})
        self.assertEqual(self.result("config", "get", "physics.gravity")["value"], 0)
        self.assertEqual(self.result("config", "set", "physics.gravity", "5"), {"key": "physics.gravity", "value": 5})
        self.assertEqual(json.loads((self.daemon.profile / "config.json").read_text())["physics"]["gravity"], 5)
        self.assertEqual(self.result("config", "get", "physics.gravity")["value"], 5)
        self.assertEqual(self.error("config", "set", "physics.restitution", "2"), "bad_value")
        self.assertEqual(self.result("reload"), {})
        self.assertIn("did you mean", self.ctl("spwan", code=2))
        listener = self.start("events", "spawn")
        listener.wait_for_text('"ok":true', 30)
        self.result("spawn")
        listener.wait_for_text('"event":"spawn"', 30)
        self.assertEqual(self.result("quit"), {})
        self.assertEqual(self.daemon.program.wait(20), 0)
        self.assertEqual(listener.wait(20), 0)
        self.assertIn("no hyrax runs with the profile", self.ctl("status", code=3))

    def test_an_open_menu_holds_no_client_up(self):
        self.daemon.wait_for_pets(lambda pets: len(pets) == 1)
        (tray,) = self.desk.windows("Wine System Tray")
        self.desk.click(tray.x + 10, tray.y + 10, button=3)
        menus = lambda: [window for window in self.desk.windows("^hyrax.exe$") if window.name == ""]
        desktop.wait_for(menus, 10, "the menu")
        question = self.start("status")
        # Of these seconds most go by until Wine has started the client.
        self.assertEqual(question.wait(20), 0)
        self.assertEqual(json.loads(question.text())["result"]["pets"], 1)
        self.result("spawn")
        self.daemon.wait_for_pets(lambda pets: len(pets) == 2, 10, "the second pet beside the menu")
        self.assertEqual(len(menus()), 1)
        self.assertEqual(self.result("quit"), {})
        self.assertEqual(self.daemon.program.wait(10), 0)

    def test_clients_cost_no_frame(self):
        self.daemon.wait_for_pets(lambda pets: len(pets) == 1)
        quiet = self.frame_rate(lambda: time.sleep(3.0))
        # Programs that start take the machine's time, but the daemon waits for none of them.
        busy = self.frame_rate(lambda: [self.result("list") for _ in range(5)])
        self.assertGreater(busy, 0.2 * quiet)

    def frame_rate(self, act):
        """Frames that the daemon draws in a second, while this is done."""
        first, begin = self.result("status")["frames"], time.monotonic()
        act()
        return (self.result("status")["frames"] - first) / (time.monotonic() - begin)


if __name__ == "__main__":
    EXE, CTL = (Path(argument).resolve() for argument in sys.argv[1:3])
    del sys.argv[1:3]
    unittest.main(verbosity=2)
