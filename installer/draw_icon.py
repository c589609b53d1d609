#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the program's icon, a hyrax's head: writes hyrax.ico beside itself.

Run: python3 draw_icon.py (needs rsvg-convert from librsvg).
"""

import pathlib
import struct
import subprocess
import zlib

SIZES = (16, 20, 24, 32, 40, 48, 64, 256)
PNG_FROM = 256  # smaller images are bitmaps, which every program reads

OUTLINE, FUR, FUR_DARK, CREAM, BLACK = "#35271e", "#a08a70", "#755f4b", "#efe3c8", "#1d1817"

HEAD = ("M50 14C66 10 84 22 88 44C91 58 88 72 78 82C70 90 60 93 50 93C40 93 30 90 22 82"
        "C12 72 9 58 12 44C16 22 34 10 50 14Z")
MUZZLE = "M50 55C62 55 73 62 73 73C73 84 62 90 50 90C38 90 27 84 27 73C27 62 38 55 50 55Z"


def ellipse(x, y, rx, ry, colour, extra=""):
    return f'<ellipse cx="{x}" cy="{y}" rx="{rx}" ry="{ry}" fill="{colour}" {extra}/>'


def line(path, width, colour=OUTLINE):
    return (f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="{width}" '
            'stroke-linecap="round" stroke-linejoin="round"/>')


def both_sides(shapes):
    return f'{shapes}<g transform="translate(100 0) scale(-1 1)">{shapes}</g>'


def svg(size):
    """Small sizes leave out what would be less than a pixel, and thicken the rest."""
    small = size <= 24
    edge = 7 if small else 4
    outlined = f'stroke="{OUTLINE}" stroke-width="{edge}" stroke-linejoin="round"'
    ear = ellipse(17, 27, 12, 13, FUR_DARK, outlined)
    hollow = "" if small else ellipse(18, 29, 6, 7, "#4a372d")
    eye = ellipse(32, 48, 8 if small else 6.5, 9 if small else 8, BLACK)
    gleam = ellipse(34.5, 44.5, 3 if small else 2.4, 3 if small else 2.8, "#fff")
    brow = ellipse(31, 32, 9, 4.5, CREAM, 'transform="rotate(-14 31 32)"')
    brow_line = "" if small else line("M23 35.5Q30 28.5 38 29.5", 2.6)
    forehead = f'<path d="M50 15C58 15 62 24 60 36C58 46 42 46 40 36C38 24 42 15 50 15Z" fill="{FUR_DARK}"/>'
    face = [
        both_sides(ear + hollow),
        f'<path d="{HEAD}" fill="{FUR}" {outlined}/>',
        "" if small else forehead,
        f'<path d="{MUZZLE}" fill="{CREAM}"/>',
        both_sides(brow + brow_line + eye + gleam),
        f'<path d="M50 71C44 71 39 66 40 61C41 57 59 57 60 61C61 66 56 71 50 71Z" fill="{BLACK}"/>',
    ]
    if not small:
        face += [line("M50 71V78M50 78Q44 84 37 80M50 78Q56 84 63 80", 2.6),
                 both_sides(line("M30 72L10 68M30 77L12 80", 1.6, "#85715c"))]
    return ('<svg xmlns="http://www.w3.org/2000/svg" viewBox="2 5 96 96" '
            f'width="{size}" height="{size}">{"".join(face)}</svg>')


def rendered(size):
    command = ["rsvg-convert", "--format", "png", "--width", str(size), "--height", str(size)]
    return subprocess.run(command, input=svg(size).encode(), capture_output=True, check=True).stdout


def chunks(png):
    at = 8
    while at < len(png):
        length, kind = struct.unpack_from(">I4s", png, at)
        yield kind, png[at + 8:at + 8 + length]
        at += length + 12


def rows(png, size):
    """The RGBA rows of a PNG file with 8 bits a channel; undoes the filters (PNG, section 9)."""
    data = zlib.decompress(b"".join(body for kind, body in chunks(png) if kind == b"IDAT"))
    stride = 4 * size
    above = bytearray(stride)
    for y in range(size):
        kind = data[y * (stride + 1)]
        row = bytearray(data[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up, corner = (row[i - 4], above[i], above[i - 4]) if i >= 4 else (0, above[i], 0)
            estimate = left + up - corner
            nearest = min((left, up, corner), key=lambda value: abs(estimate - value))
            row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest)[kind]) % 256
        above = row
        yield bytes(row)


def bitmap(png, size):
    """A 32-bit bitmap from the bottom up, and the old 1-bit mask: a pixel is clear or it is not."""
    colours, mask = b"", b""
    for row in reversed(list(rows(png, size))):
        pixels = [row[i:i + 4] for i in range(0, len(row), 4)]
        colours += b"".join(bytes((b, g, r, a)) for r, g, b, a in pixels)
        bits = "".join("1" if pixel[3] == 0 else "0" for pixel in pixels)
        bits += "0" * (-len(bits) % 32)
        mask += int(bits, 2).to_bytes(len(bits) // 8, "big")
    header = struct.pack("<IiiHHIIiiII", 40, size, 2 * size, 1, 32, 0, len(colours), 0, 0, 0, 0)
    return header + colours + mask


def main():
    images = [(size, rendered(size)) for size in SIZES]
    images = [(size, png if size >= PNG_FROM else bitmap(png, size)) for size, png in images]
    directory = struct.pack("<HHH", 0, 1, len(images))
    at = len(directory) + 16 * len(images)
    for size, image in images:
        directory += struct.pack("<BBBBHHII", size % 256, size % 256, 0, 0, 1, 32, len(image), at)
        at += len(image)
    icon = directory + b"".join(image for _, image in images)
    pathlib.Path(__file__).with_name("hyrax.ico").write_bytes(icon)


if __name__ == "__main__":
    main()
