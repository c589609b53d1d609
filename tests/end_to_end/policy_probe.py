# SPDX-License-Identifier: MIT
"""What policy_probe.exe does to hyrax: it fills screens, and tells what Wine itself does not."""

import desktop
import fixture

# The numbers of daemon/win32/messages.h.
TEST_FACT = 0x8000 + 22
ON_BATTERY, DISPLAY_OFF, ANIMATIONS, SCREENS, WIDER = 1, 4, 5, 6, 7


class BesidePrograms(fixture.OnDesktop):
    MONITORS = desktop.THREE_MONITORS

    def full_screen_on(self, monitor):
        width, height, left, top = monitor
        return self.ready_probe("front", left, top, width, height)

    def send(self, message, wparam=0, lparam=0, to="hyrax.daemon"):
        """What the windows of that class answer, a line each."""
        answers = self.ask("send", to, message, wparam, lparam)
        self.assertIn("answer", answers)
        return answers

    def tell(self, fact, value):
        """A fact about the system, as if Windows had told it."""
        self.send(TEST_FACT, fact, value)
