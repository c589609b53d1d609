#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the leaf: writes sheet.png beside itself. Run: python3 draw.py (needs rsvg-convert)."""

import pathlib
import subprocess

CELL = 44
LEAF = ('<path d="M0,-17 C12,-12 14,2 0,15 C-14,2 -12,-12 0,-17 Z" fill="#c8632a" stroke="#6d2f14" '
        'stroke-width="2" stroke-linejoin="round"/>'
        '<path d="M0,-15 V19 M0,-6 L6,-10 M0,-6 L-6,-10 M0,2 L7,-3 M0,2 L-7,-3" fill="none" '
        'stroke="#6d2f14" stroke-width="1.5" stroke-linecap="round"/>')


def main():
    folder = pathlib.Path(__file__).resolve().parent
    cells = "".join(
        f'<g transform="translate({i * CELL + CELL / 2},{CELL / 2}) rotate({i * 60}) '
        f'scale({0.5 if i % 3 == 1 else 1},1)">{LEAF}</g>' for i in range(6))
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" width="{CELL * 6}" height="{CELL}">{cells}</svg>'
    subprocess.run(["rsvg-convert", "-o", str(folder / "sheet.png")], input=svg.encode(), check=True)


if __name__ == "__main__":
    main()
