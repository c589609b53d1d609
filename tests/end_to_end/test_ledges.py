# SPDX-License-Identifier: MIT
"""hyrax.exe under Wine and the tops of real windows.

Usage: test_ledges.py hyrax.exe ledge_probe.exe [folder for screenshots]
"""

import sys
import time
from pathlib import Path

import fixture
from daemon import BOX, FUR, pets_at
from fixture import WALLPAPER

PICTURES = None


class OnWindows(fixture.OnDesktop):
    def show(self, x, y, width, height, how="show"):
        return self.ready_probe(how, x, y, width, height)

    def close(self, window):
        self.ask("close")
        self.assertEqual(window.wait(30), 0)

    def falling(self, x, y, ledges="all", drowsy_after=60):
        """A daemon whose one pet begins there."""
        return self.daemon({"overlay": {"ledges": ledges}, **pets_at((x, y), drowsy_after=drowsy_after)})

    def picture(self, name):
        return self.desk.screenshot(PICTURES / f"{name}.png" if PICTURES else None)

    def at_rest(self, daemon, x, y):
        """Waits until the one pet rests with its feet there."""

        def rests(pets):
            (pet,) = pets or (None,)
            return pet and (pet["x"], pet["y"], pet["vx"], pet["motion"]) == (x, y - BOX[1], 0, "settled")

        daemon.wait_for_pets(rests, 30, f"the pet on {x}, {y}")
        time.sleep(0.3)  # the picture follows the trace

    def test_a_pet_lands_on_a_window_goes_with_it_and_falls_when_it_closes(self):
        window = self.show(400, 400, 300, 200)
        daemon = self.falling(500, 100)
        self.at_rest(daemon, 500, 400)
        picture = self.picture("ledge-rest")
        self.assertNotIn(picture[500 + FUR[0], 400 - BOX[1] + FUR[1]], (WALLPAPER, (255, 255, 255)))
        self.assertEqual(picture[690, 410], (255, 255, 255))

        self.ask("move", 460, 340)
        self.at_rest(daemon, 560, 340)
        picture = self.picture("ledge-carried")
        self.assertNotIn(picture[560 + FUR[0], 340 - BOX[1] + FUR[1]], (WALLPAPER, (255, 255, 255)))
        # Never in the air on its way.
        landed = max(i for i, row in enumerate(daemon.rows()) if row["motion"] == "airborne")
        self.assertTrue(all(row["y"] == 400 - BOX[1] or row["y"] == 340 - BOX[1] for row in daemon.rows()[landed + 1 :]))

        self.close(window)
        self.at_rest(daemon, 560, 720)
        self.picture("ledge-fallen")

    def test_a_window_that_is_yanked_leaves_its_pet_behind(self):
        self.show(400, 300, 300, 100)
        daemon = self.falling(500, 100)
        self.at_rest(daemon, 500, 300)
        self.ask("move", 400, 600)
        self.at_rest(daemon, 500, 600)
        self.assertTrue(any(300 - BOX[1] < row["y"] < 500 for row in daemon.rows()))

    def test_a_window_of_a_hidden_owner_carries_nobody(self):
        self.show(400, 400, 300, 200, "show-owned")
        daemon = self.falling(500, 100)
        self.at_rest(daemon, 500, 720)

    def test_off_by_default_pets_fall_past_windows(self):
        self.show(400, 400, 300, 200)
        daemon = self.falling(500, 100, ledges="off")
        self.at_rest(daemon, 500, 720)

    def test_a_pet_on_a_window_draws_nothing_and_one_on_the_floor_wakes_nobody(self):
        window = self.show(400, 400, 300, 200)
        daemon = self.falling(500, 100, drowsy_after=0)
        self.at_rest(daemon, 500, 400)
        time.sleep(22)  # six breaths, then it lies still
        rows = len(daemon.rows())
        time.sleep(5)
        self.assertEqual(len(daemon.rows()), rows)
        self.close(window)
        self.at_rest(daemon, 500, 720)
        time.sleep(22)
        before = daemon.program.wakeups()
        # A window that comes and goes is nobody's business.
        self.show(100, 100, 200, 100)
        time.sleep(5)
        self.assertLessEqual(daemon.program.woken_since(before), 2)


if __name__ == "__main__":
    PICTURES = Path(sys.argv.pop(3)) if len(sys.argv) > 3 else None
    fixture.main("hyrax", "probe")
