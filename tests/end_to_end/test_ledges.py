# SPDX-License-Identifier: MIT
"""hyrax.exe under Wine and the tops of real windows.

Usage: test_ledges.py hyrax.exe ledge_probe.exe [folder for screenshots]
"""

import sys
import time
import unittest
from pathlib import Path

import desktop
from daemon import BOX, FUR, Daemon

EXE = PROBE = PICTURES = None

WALLPAPER = (0x20, 0x40, 0x60)


class OnWindows(unittest.TestCase):
    def setUp(self):
        self.desk = self.enterContext(
            desktop.VirtualDesktop([(1280, 720, 0, 0)], wallpaper="#%02x%02x%02x" % WALLPAPER)
        )

    def probe(self, *words):
        program = self.desk.start(PROBE, *words)
        self.addCleanup(program.end)
        return program

    def show(self, x, y, width, height):
        window = self.probe("show", x, y, width, height)
        window.wait_for_text("^ready$", 60)
        return window

    def daemon(self, x, y, ledges="all", drowsy_after=60):
        pets = {"start": [{"x": x, "y": y}], "drowsy_after": drowsy_after}
        config = {"overlay": {"ledges": ledges}, "pets": pets}
        daemon = Daemon(self.desk, EXE, config)
        self.addCleanup(daemon.end)
        return daemon

    def picture(self, name):
        return self.desk.screenshot(Path(PICTURES) / f"{name}.png" if PICTURES else None)

    def at_rest(self, daemon, x, y):
        """Waits until the one pet rests with its feet there."""

        def rests(pets):
            (pet,) = pets or (None,)
            return pet and (pet["x"], pet["y"], pet["vx"], pet["motion"]) == (x, y - BOX[1], 0, "settled")

        daemon.wait_for_pets(rests, 30, f"the pet on {x}, {y}; last: {daemon.pets()}")
        time.sleep(0.3)  # the picture follows the trace

    def test_a_pet_lands_on_a_window_goes_with_it_and_falls_when_it_closes(self):
        window = self.show(400, 400, 300, 200)
        daemon = self.daemon(500, 100)
        self.at_rest(daemon, 500, 400)
        picture = self.picture("ledge-rest")
        self.assertNotIn(picture[500 + FUR[0], 400 - BOX[1] + FUR[1]], (WALLPAPER, (255, 255, 255)))
        self.assertEqual(picture[690, 410], (255, 255, 255))

        self.assertEqual(self.probe("move", 460, 340).wait(30), 0)
        self.at_rest(daemon, 560, 340)
        picture = self.picture("ledge-carried")
        self.assertNotIn(picture[560 + FUR[0], 340 - BOX[1] + FUR[1]], (WALLPAPER, (255, 255, 255)))
        # Never in the air on its way.
        landed = max(i for i, row in enumerate(daemon.rows()) if row["motion"] == "airborne")
        self.assertTrue(all(row["y"] == 400 - BOX[1] or row["y"] == 340 - BOX[1] for row in daemon.rows()[landed + 1 :]))

        self.assertEqual(self.probe("close").wait(30), 0)
        self.assertEqual(window.wait(30), 0)
        self.at_rest(daemon, 560, 720)
        self.picture("ledge-fallen")

    def test_a_window_that_is_yanked_leaves_its_pet_behind(self):
        self.show(400, 300, 300, 100)
        daemon = self.daemon(500, 100)
        self.at_rest(daemon, 500, 300)
        self.assertEqual(self.probe("move", 400, 600).wait(30), 0)
        self.at_rest(daemon, 500, 600)
        self.assertTrue(any(300 - BOX[1] < row["y"] < 500 for row in daemon.rows()))

    def test_off_by_default_pets_fall_past_windows(self):
        self.show(400, 400, 300, 200)
        daemon = self.daemon(500, 100, ledges="off")
        self.at_rest(daemon, 500, 720)

    def test_a_pet_on_a_window_draws_nothing_and_one_on_the_floor_wakes_nobody(self):
        window = self.show(400, 400, 300, 200)
        daemon = self.daemon(500, 100, drowsy_after=0)
        self.at_rest(daemon, 500, 400)
        time.sleep(22)  # six breaths, then it lies still
        rows = len(daemon.rows())
        time.sleep(5)
        self.assertEqual(len(daemon.rows()), rows)
        self.assertEqual(self.probe("close").wait(30), 0)
        self.assertEqual(window.wait(30), 0)
        self.at_rest(daemon, 500, 720)
        time.sleep(22)
        before = {thread.id: thread.wakeups for thread in daemon.program.threads()}
        # A window that comes and goes is nobody's business.
        self.show(100, 100, 200, 100)
        time.sleep(5)
        woken = sum(t.wakeups - before.get(t.id, 0) for t in daemon.program.threads())
        self.assertLessEqual(woken, 2)


if __name__ == "__main__":
    missing = desktop.missing_tools()
    if missing:
        sys.exit(f"these programs are missing: {', '.join(missing)}")
    EXE, PROBE = (Path(argument).resolve() for argument in sys.argv[1:3])
    PICTURES = sys.argv[3] if len(sys.argv) > 3 else None
    unittest.main(argv=sys.argv[:1], verbosity=2)
