# SPDX-License-Identifier: MIT
"""Runs a Windows program on a display and in a Wine prefix of its own.

Usage: on_a_desktop.py program.exe [argument...]
"""

import sys
from pathlib import Path

import desktop

if __name__ == "__main__":
    with desktop.VirtualDesktop(compositor=False) as desk:
        program = desk.start(Path(sys.argv[1]).resolve(), *sys.argv[2:])
        code = program.wait(120)
        print(program.text())
    sys.exit(code)
