# SPDX-License-Identifier: MIT
"""What tests under Wine stand on: a desktop, the programs of the command line, windows that come and go."""

import sys
import time
import unittest
from pathlib import Path

import desktop
from daemon import Daemon

WALLPAPER = (0x20, 0x40, 0x60)

# Paths by the names that main() is given.
programs = {}


class OnDesktop(unittest.TestCase):
    """The tests of a class share a desktop; what a test starts ends with it."""

    MONITORS = [(1280, 720, 0, 0)]
    COMPOSITOR = True

    @classmethod
    def setUpClass(cls):
        colour = "#%02x%02x%02x" % WALLPAPER
        cls.desk = cls.enterClassContext(desktop.VirtualDesktop(cls.MONITORS, cls.COMPOSITOR, colour))

    def setUp(self):
        self.addCleanup(self._wait_for_an_empty_desktop)

    def _wait_for_an_empty_desktop(self):
        """A window outlives its killed program for a moment, in which the next daemon would stand still
        behind one that fills the screen."""
        ours = lambda: self.desk.windows(r"^hyrax\.exe$|_probe\.exe$")
        desktop.wait_for(lambda: not ours(), 20, lambda: f"windows to go: {ours()}")

    def program(self, name, *arguments):
        """One of the command line."""
        program = self.desk.start(programs[name], *arguments)
        self.addCleanup(program.end)
        return program

    def daemon(self, config, **options):
        daemon = Daemon(self.desk, programs["hyrax"], config, **options)
        self.addCleanup(daemon.end)
        return daemon

    def quit(self, daemon):
        """By a second start."""
        self.assertEqual(daemon.second_start("--quit"), 0)
        self.assertEqual(daemon.program.wait(10), 0)

    def assert_still(self, daemon):
        """No pet goes anywhere within a second."""
        places = lambda: [(pet["x"], pet["y"]) for pet in daemon.pets()]
        before = places()
        time.sleep(1.0)
        self.assertEqual(places(), before)

    # --- probes, which play other programs ----------------------------------------------------

    def probe(self, *arguments):
        return self.program("probe", *arguments)

    def ready_probe(self, *arguments):
        """One that stays, once it has shown its window."""
        probe = self.probe(*arguments)
        probe.wait_for_text("^ready$", 60)
        return probe

    def ask(self, *arguments):
        """All that a probe prints."""
        return self.text_of(self.probe(*arguments))

    def text_of(self, program, code=0):
        """All that it prints until it ends, which it must do with this code."""
        self.assertEqual(program.wait(60), code, program.text())
        return program.text()

    # --- windows of hyrax ---------------------------------------------------------------------

    def panes(self):
        """(x, y, width, height) of the visible ones."""
        return [(pane.x, pane.y, pane.width, pane.height) for pane in self.desk.windows("hyrax pane")]

    def menus(self):
        """Open menus and submenus: windows without a name."""
        return [window for window in self.desk.windows("^hyrax.exe$") if window.name == "" and window.width > 60]

    def open_menu(self, x=None, y=None):
        """By a right click there, without a place on the tray's icon."""
        if x is None:
            # Without a tray, Wine shows the icons in a window of their own.
            (tray,) = self.desk.windows("Wine System Tray")
            x, y = tray.x + 10, tray.y + 10
        self.desk.click(x, y, button=3)
        return desktop.wait_for(self.menus, 10, "the menu")[0]


def main(*names):
    """Runs the tests of the script: its command line begins with these programs; the rest is unittest's."""
    if missing := desktop.missing_tools():
        sys.exit(f"these programs are missing: {', '.join(missing)}")
    script, *words = sys.argv
    if len(words) < len(names):
        sys.exit(f"usage: {Path(script).name} {' '.join(f'{name}.exe' for name in names)} [test...]")
    programs.update((name, Path(word).resolve()) for name, word in zip(names, words))
    unittest.main(argv=[script, *words[len(names) :]], verbosity=2)
