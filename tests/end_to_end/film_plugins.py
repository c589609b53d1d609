# SPDX-License-Identifier: MIT
"""Films the shipped plugins: hyraxes thrown at the basket, a gust of wind, the full hour.

Usage: film_plugins.py hyrax.exe FOLDER
Writes FOLDER/plugins.gif. The clock strikes if a full hour comes within twenty minutes: it is waited for.
"""

import shutil
import sys
import threading
import time
from pathlib import Path

import desktop
import show
from daemon import Daemon, grip

SECONDS = 22
CONFIG = {
    "scripts": {"run": []},
    "pets": {"start": [{"count": 3}], "max": 60},
    "plugins": {
        "catch": {"enabled": True, "seconds": 20},
        "weather": {"enabled": True, "calm": 9, "leaves": 12},
        "clock": {"enabled": True, "quiet_from": 0, "quiet_to": 0},
    },
}
GRANTED = {"granted": {"weather": ["pets.others", "wind"]}}


class Player(threading.Thread):
    """Throws whatever hyrax sits near the basket, until it is told to stop."""

    def __init__(self, desk, daemon):
        super().__init__(daemon=True)
        self._desk, self._daemon, self.done = desk, daemon, threading.Event()

    def run(self):
        while not self.done.wait(1.2):
            pets = self._daemon.pets()
            basket = next((pet for pet in pets if pet["kind"] == "catch/basket"), None)
            balls = [pet for pet in pets if pet["kind"] == "hyrax" and pet["motion"] == "settled"]
            if basket and balls:
                self._throw(max(balls, key=lambda ball: abs(ball["x"] - basket["x"])), basket)

    def _throw(self, ball, basket):
        x, y = grip(ball)
        far = basket["x"] - ball["x"]
        self._desk.drag([(x + far * 0.3 * i / 10, y - 24 * i) for i in range(11)], seconds=0.3)


def wait_for_the_hour():
    """Until six seconds before it, if it is near."""
    left = 3600 - time.time() % 3600
    if 10 < left < 1200:
        print(f"waiting {left - 10:.0f} s for the full hour", flush=True)
        time.sleep(left - 10)


def main():
    show.FRAMES_A_SECOND, show.GIF_WIDTHS = 8, (640, 480)  # it is long
    exe, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    frames = show.emptied(folder / "frames")
    wallpaper = show.paint_wallpaper(folder)
    with desktop.VirtualDesktop([(*show.SIZE, 0, 0)], wallpaper=wallpaper, click_through=False) as desk:
        wait_for_the_hour()
        daemon = Daemon(desk, exe, CONFIG, state=GRANTED)
        daemon.wait_for_pets(lambda pets: len(pets) >= 6, 60, "the plugins' pets")
        show.without_tray(desk)
        player = Player(desk, daemon)
        player.start()
        names = show.film(desk, SECONDS, frames)
        player.done.set()
        player.join()
        print(daemon.log_text())
        daemon.end()
    show.write_gif(names, folder / "plugins.gif")
    shutil.rmtree(frames)


if __name__ == "__main__":
    main()
