# SPDX-License-Identifier: MIT
"""Tests the test bench: does a Win32 program see and feel what desktop.py promises?

Usage: test_desktop.py window_probe.exe
"""

import re
import time
import unittest

import desktop
import fixture
import wine


class ThreeMonitors(fixture.OnDesktop):
    # Sizes and offsets that no mix-up of axes or signs would survive.
    MONITORS = desktop.THREE_MONITORS

    def window(self, x, y, width, height):
        def is_shown():
            return self.desk.screenshot()[x + 5, y + 5] == (255, 255, 255)

        # The picture of a window that has gone must not get into the next test's screenshot.
        self.addCleanup(lambda: desktop.wait_for(lambda: not is_shown(), 10, "the window to go"))
        program = self.ready_probe(x, y, width, height)
        desktop.wait_for(is_shown, 10, "the window")
        return program

    def test_windows_program_sees_all_monitors(self):
        program = self.window(10, 10, 50, 50)
        seen = re.findall(r"^monitor (-?\d+) (-?\d+) (-?\d+) (-?\d+) (\w+)$", program.text(), re.MULTILINE)
        expected = [(x, y, x + w, y + h) for w, h, x, y in self.MONITORS]
        self.assertCountEqual([tuple(map(int, row[:4])) for row in seen], expected)
        self.assertEqual([row[4] for row in seen if row[:2] == ("0", "0")], ["primary"])

    def test_click_arrives_at_negative_coordinates(self):
        program = self.window(-900, -100, 300, 200)
        self.desk.click(-777, -55)
        program.wait_for_text("^up -777 -55$")
        self.assertIn("down -777 -55\n", program.text())
        self.assertEqual(self.desk.pointer(), (-777, -55))

    def test_click_beside_the_window_does_not_arrive(self):
        program = self.window(1400, 300, 100, 100)
        self.desk.click(1390, 350)
        self.desk.click(1450, 350)
        program.wait_for_text("^up ")
        self.assertEqual(program.text().count("down"), 1)

    def test_drag_goes_from_the_first_to_the_last_point(self):
        program = self.window(-300, 100, 500, 300)
        self.desk.drag([(-200, 150), (-100, 200), (0, 250), (100, 300)], seconds=0.2)
        program.wait_for_text("^up 100 300$")
        self.assertIn("down -200 150\n", program.text())

    def test_window_is_found_where_it_stands(self):
        self.window(-500, 50, 120, 80)
        (window,) = self.desk.windows("hyrax window probe")
        self.assertEqual((window.x, window.y, window.width, window.height), (-500, 50, 120, 80))
        self.assertEqual(self.desk.shape(window), (-500, 50, 120, 80))

    def test_screenshot_counts_as_windows_does(self):
        before = self.desk.screenshot()
        self.assertEqual(before[-1000, -100], fixture.WALLPAPER)
        self.window(-700, 400, 64, 32)
        after = self.desk.screenshot(self.desk.folder / "after.png")
        self.assertEqual(after.changed_box(before), (-700, 400, 64, 32))
        self.assertEqual(after.crop(-700, 400, 64, 32).count((255, 255, 255)), 64 * 32)

    def test_idle_program_does_not_wake(self):
        program = self.window(600, 400, 50, 50)
        before = program.wakeups()
        self.assertTrue(before)
        time.sleep(1.0)
        self.assertLessEqual(program.woken_since(before), 5)


class Teardown(unittest.TestCase):
    def test_nothing_is_left_and_others_live_on(self):
        probe = fixture.programs["probe"]
        with desktop.VirtualDesktop(compositor=False) as other:
            survivor = other.start(probe, 0, 0, 20, 20)
            survivor.wait_for_text("^ready$", 60)
            with desktop.VirtualDesktop(compositor=False) as desk:
                program = desk.start(probe, 0, 0, 20, 20)
                program.wait_for_text("^ready$", 60)
                self.assertTrue(any("window_probe" in line for _, line in desk.processes()))
                prefix = desk.prefix
            self.assertFalse(program.running)
            self.assertEqual(wine.processes(prefix), [])
            self.assertFalse(prefix.exists())
            self.assertTrue(survivor.running)


if __name__ == "__main__":
    fixture.main("probe")
