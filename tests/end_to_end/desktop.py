# SPDX-License-Identifier: MIT
"""A desktop of its own for tests under Wine: monitors, compositor, mouse, screenshots.

All coordinates are those of the virtual desktop, as Windows counts them: (0, 0) is the top-left
corner of the primary monitor, the first one given; others may lie at negative coordinates.
"""

import dataclasses
import os
import re
import shutil
import subprocess
import time
from pathlib import Path

import wine
from image import Screen
from program import Program, wait_for

# With XRandR Wine sees one monitor however many are named; its Xinerama path sees all of them.
#
# Wine cuts a layered window to its visible pixels, so that clicks beside them reach what lies below;
# the cut lags a frame behind the picture, so what moves has ragged edges. Without it the edges are
# as they are on Windows, and clicks are not.
REGISTRY = """[Software\\\\Wine\\\\X11 Driver]
"UseXRandR"="N"
"ShapeLayeredWindows"="%s"

[Software\\\\Wine\\\\WineDbg]
"ShowCrashDialog"=dword:00000000
"""


# The second one lies left of and above the primary, the third one is smaller.
THREE_MONITORS = [(1280, 720, 0, 0), (1024, 768, -1024, -120), (800, 600, 1280, 200)]


@dataclasses.dataclass(frozen=True)
class Window:
    """An X window as it stands on the virtual desktop."""

    id: str
    name: str
    kind: str
    x: int
    y: int
    width: int
    height: int


class VirtualDesktop:
    """A context manager; `monitors` are (width, height, x, y), the primary first and at 0, 0.

    `wallpaper` is a colour such as "#203040" or a picture's path. Without a compositor translucent
    pixels show dark. Without `click_through` moving pets have clean edges. `folder` keeps logs and
    outputs; by default they go when the desktop goes.
    """

    def __init__(
        self,
        monitors=((1280, 720, 0, 0),),
        compositor=True,
        wallpaper="#3a6ea5",
        window_manager=False,
        folder=None,
        click_through=True,
    ):
        if tuple(monitors[0][2:]) != (0, 0):
            raise ValueError("the first monitor is the primary one and must be at 0, 0")
        self.monitors = [tuple(monitor) for monitor in monitors]
        left, top = min(m[2] for m in monitors), min(m[3] for m in monitors)
        self.origin = (left, top)
        self.size = (
            max(m[2] + m[0] for m in monitors) - left,
            max(m[3] + m[1] for m in monitors) - top,
        )
        self._compositor, self._wallpaper, self._window_manager = compositor, wallpaper, window_manager
        self._folder = Path(folder) if folder else None
        self._registry = REGISTRY % ("Y" if click_through else "N")
        self._helpers, self._programs = [], []
        self.display = self.prefix = self._screen = None

    # --- set-up and teardown ------------------------------------------------------------------

    def __enter__(self):
        try:
            self.prefix = wine.clone(self._registry)
            wine.keep_server(self.prefix)
            self.folder = self._folder or self.prefix / "logs"
            self.folder.mkdir(parents=True, exist_ok=True)
            self._start_server()
            self._name_monitors()
            self._decorate()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for program in self._programs:
            program.end()
        if self.prefix:
            wine.remove(self.prefix)
        if self._screen:
            self._screen.close()
        # The server last: the others would complain of its loss.
        for helper in reversed(self._helpers):
            helper.terminate()
            try:
                helper.wait(5)
            except subprocess.TimeoutExpired:
                helper.kill()
                helper.wait()

    def _helper(self, *command, **options):
        log = open(self.folder / f"{Path(command[0]).name}.log", "ab")
        with log:
            self._helpers.append(
                subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=log, env=self._x_env, **options)
            )
        return self._helpers[-1]

    @property
    def env(self):
        """The environment of the Windows programs on this desktop."""
        return wine.environment(self.prefix, self.display)

    @property
    def _x_env(self):
        return {**os.environ, "DISPLAY": self.display or ""}

    def _start_server(self):
        reader, writer = os.pipe()
        screen = f"{self.size[0]}x{self.size[1]}x24"
        # -displayfd: the server itself picks a free number. -noreset: else it forgets the monitors
        # whenever its last client goes.
        server = self._helper(
            "Xvfb", "-displayfd", str(writer), "-noreset", "-nolisten", "tcp", "-screen", "0", screen, "-dpi", "96",
            pass_fds=(writer,),
        )  # fmt: skip
        os.close(writer)
        with os.fdopen(reader) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise RuntimeError(f"Xvfb did not start (exit code {server.wait()})")
        self.display = f":{number}"
        self._screen = Screen(self.display, self.size, self.origin)

    @property
    def server_pid(self):
        return self._helpers[0].pid

    def run(self, *command, seconds=20.0):
        """The output of an X tool."""
        result = subprocess.run(command, env=self._x_env, capture_output=True, timeout=seconds)
        if result.returncode != 0:
            raise RuntimeError(f"{' '.join(command)}: {result.stderr.decode(errors='replace').strip()}")
        return result.stdout

    def _name_monitors(self):
        for number, (width, height, x, y) in enumerate(self.monitors):
            name = "*M0" if number == 0 else f"M{number}"  # the star makes it primary
            millimetres = (round(width / 96 * 25.4), round(height / 96 * 25.4))
            place = f"{width}/{millimetres[0]}x{height}/{millimetres[1]}+{x - self.origin[0]}+{y - self.origin[1]}"
            self.run("xrandr", "--setmonitor", name, place, "screen" if number == 0 else "none")

    def _decorate(self):
        if self._window_manager:
            self._helper("openbox", "--sm-disable")
            wait_for(lambda: b"window id" in self.run("xprop", "-root", "_NET_SUPPORTING_WM_CHECK"), 10, "openbox")
        if self._wallpaper:
            picture = not str(self._wallpaper).startswith("#")
            self.run("hsetroot", "-cover" if picture else "-solid", str(self._wallpaper))
        if self._compositor:
            self._helper("picom", "--backend", "xrender", "--no-vsync", "--config", os.devnull)
            owner = lambda: b"picom" in self.run("xwininfo", "-root", "-tree")
            wait_for(owner, 10, "picom's window")

    # --- programs -----------------------------------------------------------------------------

    def start(self, exe, *arguments, env=None, cwd=None):
        """Starts a Windows program and returns it as Program."""
        output = self.folder / f"{Path(exe).stem}-{len(self._programs)}.txt"
        with open(output, "wb") as file:
            process = subprocess.Popen(
                ["wine", str(exe), *map(str, arguments)],
                stdin=subprocess.DEVNULL,
                stdout=file,
                stderr=file,
                env={**self.env, **(env or {})},
                cwd=cwd,
            )
        self._programs.append(Program(process, output))
        return self._programs[-1]

    def processes(self):
        """(pid, command line) of all Windows programs of this desktop, Wine's own included."""
        return wine.processes(self.prefix)

    # --- mouse and keyboard: X events, the only ones for which Wine heeds alpha ----------------

    def _at(self, x, y):
        return ["mousemove", str(round(x) - self.origin[0]), str(round(y) - self.origin[1])]

    def move(self, x, y):
        self.run("xdotool", *self._at(x, y))

    def press(self, button=1):
        self.run("xdotool", "mousedown", str(button))

    def release(self, button=1):
        self.run("xdotool", "mouseup", str(button))

    def click(self, x, y, button=1, hold=0.05):
        """Moves there, presses and releases; 1 left, 2 middle, 3 right."""
        self.run(
            "xdotool", *self._at(x, y), "sleep", "0.05", "mousedown", str(button),
            "sleep", str(hold), "mouseup", str(button),
        )  # fmt: skip

    def drag(self, points, seconds=0.3, button=1, release=True, settle=0.05):
        """Presses at the first point, passes the others in even steps, releases at the last one
        without a pause, so that what was held keeps the hand's velocity."""
        pause = ["sleep", f"{seconds / max(1, len(points) - 1):.4f}"]
        command = ["xdotool", *self._at(*points[0]), "sleep", str(settle), "mousedown", str(button)]
        command += ["sleep", str(settle)]
        for point in points[1:]:
            command += self._at(*point) + pause
        # The last pause would let the hand stand still.
        command = command[:-2] if len(points) > 1 else command
        self.run(*command, *(["mouseup", str(button)] if release else []), seconds=seconds + 30)

    def carry(self, points, release=True):
        """A drag whose hand stands still before it lets go."""
        x, y = points[-1]
        self.drag([*points, *[(x, y + i % 2) for i in range(8)]], seconds=1.0, release=release)

    def key(self, *names):
        """Presses keys by their X names: "Escape", "ctrl+c"."""
        self.run("xdotool", "key", *names)

    def pointer(self):
        found = dict(re.findall(r"([XY])=(-?\d+)", self.run("xdotool", "getmouselocation", "--shell").decode()))
        return int(found["X"]) + self.origin[0], int(found["Y"]) + self.origin[1]

    # --- what is seen -------------------------------------------------------------------------

    def screenshot(self, path=None):
        """What stands on the screen, as Image; also written as PNG if a path is given."""
        picture = self._screen.grab()
        if path:
            picture.write_png(path)
        return picture

    def _window_tree(self):
        """xwininfo asks for one window after another, and fails if one of them goes meanwhile."""
        for _ in range(20):
            try:
                return self.run("xwininfo", "-root", "-tree").decode(errors="replace")
            except RuntimeError as problem:
                if "Bad" not in str(problem):
                    raise
                time.sleep(0.02)
        return self.run("xwininfo", "-root", "-tree").decode(errors="replace")

    def windows(self, name=None, viewable=True):
        """X windows whose name or class matches a regular expression, topmost first."""
        line = re.compile(
            r'^\s+(0x\w+) (?:"(.*)"|\(has no name\)): \((?:"(.*?)" )?.*?\)\s+(\d+)x(\d+)\+-?\d+\+-?\d+\s+\+(-?\d+)\+(-?\d+)'
        )
        found = []
        for text in self._window_tree().splitlines():
            match = line.match(text)
            if not match:
                continue
            number, title, kind, width, height, x, y = match.groups()
            x, y = int(x) + self.origin[0], int(y) + self.origin[1]
            window = Window(number, title or "", kind or "", x, y, int(width), int(height))
            if name and not (re.search(name, window.name) or re.search(name, window.kind)):
                continue
            if not viewable or self.is_viewable(window):
                found.append(window)
        return found

    def is_viewable(self, window):
        try:
            return b"Map State: IsViewable" in self.run("xwininfo", "-id", window.id, "-stats")
        except RuntimeError:
            return False  # it went meanwhile

    def hide(self, window):
        self.run("xdotool", "windowunmap", window.id)

    def shape(self, window):
        """(x, y, width, height) around what takes clicks; the whole window where it has no shape."""
        text = self.run("xwininfo", "-id", window.id, "-shape").decode(errors="replace")
        match = re.search(r"Window shape extents:\s+(\d+)x(\d+)\+(-?\d+)\+(-?\d+)", text)
        if not match:
            return window.x, window.y, window.width, window.height
        width, height, x, y = (int(n) for n in match.groups())
        return window.x + x, window.y + y, width, height


def missing_tools():
    """Names of the programs that a virtual desktop needs and that are not installed."""
    needed = "Xvfb xrandr xwininfo xprop xdotool hsetroot picom openbox wine wineserver"
    return [tool for tool in needed.split() if not shutil.which(tool)]
