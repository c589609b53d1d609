# SPDX-License-Identifier: MIT
"""`./dev run` on a machine without a display: shows hyrax.exe on a virtual one and films it.

Usage: show.py hyrax.exe SECONDS FOLDER
Writes FOLDER/screenshot.png and FOLDER/demo.gif, and leaves the profile in FOLDER/profile.
"""

import json
import re
import shutil
import subprocess
import sys
import time
import zlib
from pathlib import Path

import desktop
import wine

SIZE = (1280, 720)
BEST = (0.4, 0.55)  # of the time: most are in the air then
FRAMES_A_SECOND = 12
GIF_LIMIT = 4 << 20
GIF_WIDTHS = (800, 640, 480)  # the widest that stays below the limit
HERE = Path(__file__).resolve().parent


def emptied(folder):
    """The folder, with nothing in it."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def paint_wallpaper(folder):
    """The path of the picture, as large as the desktop."""
    path, (width, height) = folder / "wallpaper.png", SIZE
    command = ["rsvg-convert", "-w", str(width), "-h", str(height), "-o", str(path), str(HERE / "wallpaper.svg")]
    subprocess.run(command, check=True)
    return str(path)


def without_tray(desk):
    """Without a tray Wine shows the icon in a window of its own, which no Windows desktop has."""
    for window in desk.windows("explorer.exe"):
        desk.hide(window)


def make_profile(folder):
    """A fresh profile whose config runs the example."""
    emptied(folder)
    config = {"scripts": {"run": ["examples/fountain.lua"]}}
    (folder / "config.json").write_text(json.dumps(config, indent=4) + "\n", encoding="utf-8")
    return folder


def film(desk, seconds, folder):
    """Grabs the screen until the time is over; the names of the frames, in order.

    A window that Wine resizes is empty for one picture: the screenshot is the richest of several."""
    names, begin, best, most = [], time.monotonic(), None, 0
    while (now := time.monotonic() - begin) < seconds:
        picture = desk.screenshot()
        name = folder / f"{len(names):05}.ppm"
        name.write_bytes(b"P6 %d %d 255\n" % (picture.width, picture.height) + picture.rgb)
        names.append(name)
        if not best:
            best = picture
        if BEST[0] * seconds <= now <= BEST[1] * seconds and (richness := len(zlib.compress(picture.rgb, 1))) > most:
            best, most = picture, richness
        time.sleep(max(0.0, len(names) / FRAMES_A_SECOND - (time.monotonic() - begin)))
        if sys.stdout.isatty():
            print(f"\r  filming: {now:4.1f} of {seconds:g} s", end="", flush=True)
    if sys.stdout.isatty():
        print()
    best.write_png(folder.parent / "screenshot.png", level=1)
    return names


def write_gif(frames, path):
    """One palette without dithering: what stands still is the same in each frame and costs nothing."""

    def run(*command):
        subprocess.run([str(word) for word in command], check=True)

    for width in GIF_WIDTHS:
        # mogrify takes one after the other; convert would hold all in memory and pass its limit.
        run("mogrify", "-resize", width, "-format", "png", *frames)
        small = [frame.with_suffix(".png") for frame in frames]
        palette = path.with_suffix(".png")
        run("convert", *small[:: max(1, len(small) // 12)], "-append", "+dither", "-colors", 255, palette)
        run(
            "convert", "-delay", round(100 / FRAMES_A_SECOND), "-loop", 0, *small,
            "+dither", "-remap", palette, "-layers", "Optimize", path,
        )  # fmt: skip
        palette.unlink()
        if path.stat().st_size <= GIF_LIMIT:
            break


def last_words(log):
    """The last line of the program's log, without date and level: what it counted."""
    lines = log.read_text(encoding="utf-8", errors="replace").split("\n") if log.exists() else []
    said = [line.strip() for line in lines if line.strip()]
    return re.sub(r"^[-0-9 :.]+\w+: ", "", said[-1]) if said else "no log"


def main():
    exe, seconds, folder = Path(sys.argv[1]).resolve(), float(sys.argv[2]), Path(sys.argv[3]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    profile = make_profile(folder / "profile")
    frames_folder = emptied(folder / "frames")
    wallpaper = paint_wallpaper(folder)
    print(f"showing {exe.name} on a virtual display for {seconds:g} s", flush=True)
    with desktop.VirtualDesktop([(*SIZE, 0, 0)], wallpaper=wallpaper, click_through=False) as desk:
        empty = desk.screenshot()
        program = desk.start(exe, "--profile", wine.windows_path(profile))
        desktop.wait_for(lambda: desk.screenshot().rgb != empty.rgb or not program.running, 60, "the first pet")
        if not program.running:
            sys.exit(f"error: {exe.name} ended at once: {program.text()}")
        without_tray(desk)
        before = sum(thread.cpu for thread in program.threads())
        frames = film(desk, seconds, frames_folder)
        cpu = sum(thread.cpu for thread in program.threads()) - before
        # A second start hands its option to the first one, which then has time to say good-bye.
        desk.start(exe, "--profile", wine.windows_path(profile), "--quit").wait(30)
        if code := program.wait(30):
            print(f"error: {exe.name} ended with {code}: {program.text()}", file=sys.stderr)
        told = f"{last_words(profile / 'hyrax.log')}; {100 * cpu / seconds:.0f} % of a core"
    print(f"making the picture of {len(frames)} frames", flush=True)
    write_gif(frames, folder / "demo.gif")
    shutil.rmtree(frames_folder)
    for name in ("screenshot.png", "demo.gif"):
        path = folder / name
        print(f"{path} ({path.stat().st_size / 1024:.0f} KiB)")
    print(told)


if __name__ == "__main__":
    main()
