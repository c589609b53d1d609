# SPDX-License-Identifier: MIT
"""The pictures of the documents: hyrax.exe on three monitors, on window tops, and its menu.

Usage: gallery.py hyrax.exe ledge_probe.exe FOLDER
Writes three_monitors.png, light.png, window_tops.png and tray_menu.png. Looking at them is up to you.
"""

import sys
import tempfile
import time
from pathlib import Path

import desktop
from daemon import Daemon, pets_at
from show import paint_wallpaper, without_tray

# One is left of and above the primary one, one is smaller.
THREE = [(1280, 720, 0, 0), (1024, 640, -1024, -120), (800, 480, 1280, 160)]
LIGHT = "#f4f1ea"
DARK = "#22303c"

# Sixty pets all over the place: some fly when the picture is taken, most have come to rest.
CROWD = """
math.randomseed(7)
local made = 0
hyrax.every(0.1, function()
    if made == 60 then return end
    made = made + 1
    local monitors = hyrax.monitors()
    local on = monitors[made % #monitors + 1]
    local pet = hyrax.spawn{ x = on.x + math.random() * (on.w - 110), y = on.y + math.random() * 200 }
    pet:fling(math.random(-700, 700), math.random(-500, 0))
end)
"""


def crowd(exe, monitors, paper, picture):
    config = {"pets": {"start": [], "max": 100}, "scripts": {"run": ["crowd.lua"]}}
    with desktop.VirtualDesktop(monitors, wallpaper=paper, click_through=False) as desk:
        daemon = Daemon(desk, exe, config, scripts={"crowd.lua": CROWD})
        daemon.wait_for_pets(lambda pets: len(pets) == 60, 90, "60 pets")
        without_tray(desk)
        time.sleep(1.5)
        desk.screenshot(picture)
        daemon.end()


def window_tops(exe, probe, paper, picture):
    spots = [(220, 40), (420, 10), (760, 80), (900, 20), (60, 300)]
    config = {
        "overlay": {"ledges": "all"},
        **pets_at(*spots, vx=20),
    }
    with desktop.VirtualDesktop(wallpaper=paper, click_through=False) as desk:
        for place in ((160, 320, 480, 260), (700, 420, 420, 240)):
            desk.start(probe, "show", *place).wait_for_text("^ready$", 60)
        daemon = Daemon(desk, exe, config)
        daemon.wait_for_rest(len(spots))
        without_tray(desk)
        time.sleep(0.5)
        desk.screenshot(picture)
        daemon.end()


def tray_menu(exe, paper, picture):
    with desktop.VirtualDesktop(wallpaper=paper, click_through=False) as desk:
        daemon = Daemon(desk, exe, pets_at((700, 300), (900, 200)), state={"greeted": True})
        daemon.wait_for_rest(2)
        (tray,) = desk.windows("Wine System Tray")
        desk.click(tray.x + 10, tray.y + 10, button=3)
        desktop.wait_for(lambda: [w for w in desk.windows("^hyrax.exe$") if w.name == ""], 10, "the menu")
        desk.key("h")
        time.sleep(1.0)
        desk.screenshot(picture)
        desk.key("Escape", "Escape")
        daemon.end()


def main():
    exe, probe, folder = (Path(word).resolve() for word in sys.argv[1:4])
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        paper = paint_wallpaper(Path(scratch))
        crowd(exe, THREE, DARK, folder / "three_monitors.png")
        crowd(exe, THREE[:1], LIGHT, folder / "light.png")
        window_tops(exe, probe, paper, folder / "window_tops.png")
        tray_menu(exe, paper, folder / "tray_menu.png")


if __name__ == "__main__":
    main()
