# SPDX-License-Identifier: MIT
"""A picture in plain bytes: grabbed from an X screen, asked for pixels, written as PNG."""

import ctypes
import struct
import zlib
from pathlib import Path


class Image:
    """RGB, 8 bits each. Coordinates count from `origin`, so that a screenshot of the virtual
    desktop is asked in the desktop's own coordinates, negative ones included."""

    def __init__(self, width, height, rgb, origin=(0, 0)):
        self.width, self.height, self.origin = width, height, origin
        self.rgb = bytes(rgb)
        assert len(self.rgb) == 3 * width * height

    @classmethod
    def from_bgrx(cls, width, height, stride, data, origin=(0, 0)):
        """From the 32-bit pixels that X keeps, least significant byte first."""
        rows = [data[y * stride : y * stride + 4 * width] for y in range(height)]
        bgrx = data if stride == 4 * width else b"".join(rows)
        rgb = bytearray(3 * width * height)
        rgb[0::3], rgb[1::3], rgb[2::3] = bgrx[2::4], bgrx[1::4], bgrx[0::4]
        return cls(width, height, rgb, origin)

    def __getitem__(self, position):
        """The (red, green, blue) at (x, y)."""
        x, y = position[0] - self.origin[0], position[1] - self.origin[1]
        if not (0 <= x < self.width and 0 <= y < self.height):
            raise IndexError(f"({position[0]}, {position[1]}) is outside the picture")
        at = 3 * (y * self.width + x)
        return tuple(self.rgb[at : at + 3])

    def crop(self, x, y, width, height):
        """The part at (x, y) in this picture's coordinates, which the part keeps."""
        left, top = x - self.origin[0], y - self.origin[1]
        if left < 0 or top < 0 or left + width > self.width or top + height > self.height:
            raise IndexError(f"{width}x{height}+{x}+{y} is outside the picture")
        stride = 3 * self.width
        first = top * stride + 3 * left
        rows = [self.rgb[first + n * stride : first + n * stride + 3 * width] for n in range(height)]
        return Image(width, height, b"".join(rows), (x, y))

    def count(self, colour):
        """How many pixels have exactly this colour."""
        pixels = zip(self.rgb[0::3], self.rgb[1::3], self.rgb[2::3])
        return sum(pixel == colour for pixel in pixels)

    def changed_box(self, other):
        """(x, y, width, height) around all pixels that differ from `other`, or None."""
        stride = 3 * self.width
        if (self.width, self.height) != (other.width, other.height):
            raise ValueError("pictures of different sizes")
        rows = [
            y
            for y in range(self.height)
            if self.rgb[y * stride : (y + 1) * stride] != other.rgb[y * stride : (y + 1) * stride]
        ]
        if not rows:
            return None
        left, right = self.width, 0
        for y in rows:
            mine, theirs = (i.rgb[y * stride : (y + 1) * stride] for i in (self, other))
            differing = [i for i in range(stride) if mine[i] != theirs[i]]
            left, right = min(left, differing[0] // 3), max(right, differing[-1] // 3)
        return (left + self.origin[0], rows[0] + self.origin[1], right - left + 1, rows[-1] - rows[0] + 1)

    def write_png(self, path, level=6):
        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

        stride = 3 * self.width
        rows = b"".join(b"\0" + self.rgb[y * stride : (y + 1) * stride] for y in range(self.height))
        head = struct.pack(">IIBBBBB", self.width, self.height, 8, 2, 0, 0, 0)
        Path(path).write_bytes(
            b"\x89PNG\r\n\x1a\n"
            + chunk(b"IHDR", head)
            + chunk(b"IDAT", zlib.compress(rows, level))
            + chunk(b"IEND", b"")
        )
        return Path(path)


class _XImage(ctypes.Structure):
    """The head of Xlib's struct, as far as it is read here."""

    _fields_ = [
        ("width", ctypes.c_int),
        ("height", ctypes.c_int),
        ("xoffset", ctypes.c_int),
        ("format", ctypes.c_int),
        ("data", ctypes.c_void_p),
        ("byte_order", ctypes.c_int),
        ("bitmap_unit", ctypes.c_int),
        ("bitmap_bit_order", ctypes.c_int),
        ("bitmap_pad", ctypes.c_int),
        ("depth", ctypes.c_int),
        ("bytes_per_line", ctypes.c_int),
        ("bits_per_pixel", ctypes.c_int),
    ]


class Screen:
    """Grabs what stands on an X screen, composited. xwd and import will not do: where windows of
    different depths exist they read each window for itself and lose the compositor's work."""

    def __init__(self, display, size, origin):
        self._x = ctypes.CDLL("libX11.so.6")
        self._x.XOpenDisplay.restype = ctypes.c_void_p
        self._x.XOpenDisplay.argtypes = [ctypes.c_char_p]
        self._x.XCloseDisplay.argtypes = [ctypes.c_void_p]
        self._x.XDefaultRootWindow.restype = ctypes.c_ulong
        self._x.XDefaultRootWindow.argtypes = [ctypes.c_void_p]
        self._x.XGetImage.restype = ctypes.POINTER(_XImage)
        self._x.XGetImage.argtypes = [
            ctypes.c_void_p, ctypes.c_ulong, *[ctypes.c_int] * 2, *[ctypes.c_uint] * 2, ctypes.c_ulong, ctypes.c_int
        ]  # fmt: skip
        self._x.XDestroyImage.argtypes = [ctypes.POINTER(_XImage)]
        self._size, self._origin = size, origin
        self._connection = self._x.XOpenDisplay(display.encode())
        if not self._connection:
            raise RuntimeError(f"no connection to the display {display}")

    def grab(self):
        z_pixmap, all_planes = 2, 0xFFFFFFFF
        root = self._x.XDefaultRootWindow(self._connection)
        image = self._x.XGetImage(self._connection, root, 0, 0, *self._size, all_planes, z_pixmap)
        if not image:
            raise RuntimeError("the screen could not be read")
        try:
            head = image.contents
            if head.bits_per_pixel != 32 or head.byte_order != 0:
                raise RuntimeError(f"{head.bits_per_pixel} bits a pixel, byte order {head.byte_order}: not supported")
            data = ctypes.string_at(head.data, head.height * head.bytes_per_line)
            return Image.from_bgrx(head.width, head.height, head.bytes_per_line, data, self._origin)
        finally:
            self._x.XDestroyImage(image)

    def close(self):
        if self._connection:
            self._x.XCloseDisplay(self._connection)
            self._connection = None
