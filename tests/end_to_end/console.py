# SPDX-License-Identifier: MIT
"""A Windows program in a terminal, of which Wine makes a console."""

import os
import pty
import re
import select
import subprocess
import termios
import time

import desktop

ESCAPE_SEQUENCE = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]")


class Console:
    def __init__(self, desk, exe, *arguments):
        self._terminal, inside = pty.openpty()
        self._process = subprocess.Popen(
            ["wine", str(exe), *map(str, arguments)],
            stdin=inside,
            stdout=inside,
            stderr=inside,
            env=desk.env,
            start_new_session=True,
        )
        os.close(inside)
        self._bytes = b""

    def enter(self, line):
        """Types a line; wait_for_text() then looks at what follows."""
        # What comes before Wine's console has taken the terminal over, the terminal would change.
        desktop.wait_for(self._is_raw, 10, "the console")
        self._bytes = b""
        os.write(self._terminal, f"{line}\r".encode())

    def _is_raw(self):
        local_modes = termios.tcgetattr(self._terminal)[3]
        return not local_modes & (termios.ICANON | termios.ECHO)

    def _text(self):
        text = self._bytes.decode(errors="replace")
        return ESCAPE_SEQUENCE.sub("", text).replace("\r", "")

    def wait_for_text(self, text, seconds=20.0):
        """Until it has shown the text."""
        end = time.monotonic() + seconds
        while text not in self._text():
            ready, _, _ = select.select([self._terminal], [], [], max(0, end - time.monotonic()))
            if not ready:
                raise AssertionError(f"no {text!r} after {seconds} s, but {self._text()!r}")
            self._bytes += os.read(self._terminal, 4096)

    def wait(self, seconds=20.0):
        """The exit code."""
        return self._process.wait(seconds)

    def end(self):
        if self._process.poll() is None:
            self._process.kill()
        self._process.wait()
        os.close(self._terminal)
