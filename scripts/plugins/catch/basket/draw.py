#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the basket: writes sheet.png beside itself. Run: python3 draw.py (needs rsvg-convert)."""

import pathlib
import subprocess

WIDTH, HEIGHT = 152, 112
OUTLINE = 'stroke="#4a2f1a" stroke-width="2.4" stroke-linejoin="round" stroke-linecap="round"'


def foot(x, lift):
    y = 106 - lift
    return (f'<path d="M{x - 11},{y} q-1,-9 9,-9 q12,0 12,9 z" fill="#4b403b" {OUTLINE}/>'
            f'<path d="M{x - 5},{y - 2} v2 M{x + 1},{y - 2} v2" stroke="#8d7f77" stroke-width="2"/>')


def weave(top, bottom):
    """Rows of wicker, each shifted by half a strand."""
    rows = []
    for row in range(4):
        y = top + 10 + row * (bottom - top - 14) / 4
        inset = 15 + row * 3.2
        for i in range(-1, 9):
            x = inset + i * 15 + (row % 2) * 7.5
            rows.append(f'<path d="M{x:.1f},{y:.1f} q7,-4.5 13,0 v9 q-6,4.5 -13,0 z" '
                        'fill="#d9ab68" stroke="#8a5a2c" stroke-width="1.3"/>')
    return "".join(rows)


def basket(left_lift=0, right_lift=0, squash=0.0, face="open"):
    top, bottom = 34 + 10 * squash, 98
    side = f"M12,{top + 4} L24,{bottom - 6} Q26,{bottom} 34,{bottom} H118 Q126,{bottom} 128,{bottom - 6} L140,{top + 4} Z"
    eyes = ('<circle cx="58" cy="66" r="6" fill="#1d1817"/><circle cx="94" cy="66" r="6" fill="#1d1817"/>'
            '<circle cx="60" cy="64" r="2" fill="#fff"/><circle cx="96" cy="64" r="2" fill="#fff"/>'
            if face == "open" else
            f'<path d="M51,68 q7,-10 14,0 M87,68 q7,-10 14,0" fill="none" stroke="#1d1817" stroke-width="3.2" stroke-linecap="round"/>')
    mouth = ('<path d="M70,76 q6,5 12,0" fill="none" stroke="#1d1817" stroke-width="2.6" stroke-linecap="round"/>'
             if face == "open" else
             '<path d="M66,75 q10,14 20,0 z" fill="#8c3b34" stroke="#1d1817" stroke-width="2.2" stroke-linejoin="round"/>')
    return (
        foot(54, left_lift) + foot(102, right_lift) +
        f'<ellipse cx="76" cy="{top}" rx="66" ry="13" fill="#6a4322" {OUTLINE}/>'
        f'<path d="{side}" fill="#bf8b4b"/>'
        f'<clipPath id="c"><path d="{side}"/></clipPath><g clip-path="url(#c)">{weave(top, bottom)}'
        '<path d="M24,34 L34,98 H12 V34 Z" fill="#fff" opacity=".12"/>'
        '<path d="M112,34 L104,98 H140 V34 Z" fill="#2a1708" opacity=".16"/></g>'
        f'<path d="{side}" fill="none" {OUTLINE}/>'
        f'<path d="M10,{top} a66,13 0 0 0 132,0 v7 a66,13 0 0 1 -132,0 z" fill="#e3bb7d" {OUTLINE}/>'
        '<ellipse cx="76" cy="71" rx="40" ry="17" fill="#e9c88f" opacity=".92"/>' + eyes + mouth)


CELLS = [basket(), basket(left_lift=7), basket(right_lift=7),
         basket(squash=1.0, face="happy"), basket(squash=-0.6, face="happy")]


def main():
    folder = pathlib.Path(__file__).resolve().parent
    cells = "".join(
        f'<g transform="translate({i * WIDTH},0)">{cell.replace("#c)", f"#c{i})").replace(chr(34) + "c" + chr(34), chr(34) + f"c{i}" + chr(34))}</g>'
        for i, cell in enumerate(CELLS))
    svg = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH * len(CELLS)}" height="{HEIGHT}">{cells}</svg>')
    subprocess.run(["rsvg-convert", "-o", str(folder / "sheet.png")], input=svg.encode(), check=True)


if __name__ == "__main__":
    main()
