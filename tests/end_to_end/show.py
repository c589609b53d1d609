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
from pathlib import Path

import desktop
import wine

SIZE = (1280, 720)
FRAMES_A_SECOND = 12
GIF_LIMIT = 4 << 20
GIF_WIDTHS = (800, 640, 480)  # the widest that stays below the limit
HERE = Path(__file__).resolve().parent


def make_profile(folder):
    """A fresh profile whose config runs the example."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    config = {"scripts": {"run": ["examples/fountain.lua"]}}
    (folder / "config.json").write_text(json.dumps(config, indent=4) + "\n", encoding="utf-8")
    return folder


def film(desk, seconds, folder):
    """Grabs the screen until the time is over; the names of the frames, in order."""
    names, begin = [], time.monotonic()
    while (now := time.monotonic() - begin) < seconds:
        picture = desk.screenshot()
        name = folder / f"{len(names):05}.ppm"
        name.write_bytes(b"P6 %d %d 255\n" % (picture.width, picture.height) + picture.rgb)
        names.append(name)
        time.sleep(max(0.0, len(names) / FRAMES_A_SECOND - (time.monotonic() - begin)))
        if sys.stdout.isatty():
            print(f"\r  filming: {now:4.1f} of {seconds:g} s", end="", flush=True)
    if sys.stdout.isatty():
        print()
    return names


def write_gif(frames, path):
    """One palette without dithering: what stands still is the same in each frame and costs nothing."""

    def convert(*arguments):
        subprocess.run(["convert", *map(str, arguments)], check=True)

    for width in GIF_WIDTHS:
        small = [frame.with_suffix(".png") for frame in frames]
        # One by one: all frames at once would pass ImageMagick's memory limit.
        for frame, target in zip(frames, small):
            convert(frame, "-resize", width, target)
        palette = frames[0].with_name("palette.png")
        convert(*small[:: max(1, len(small) // 12)], "-append", "+dither", "-colors", 255, palette)
        delay = round(100 / FRAMES_A_SECOND)
        convert(
            "-delay", delay, "-loop", 0, *small, "+dither", "-remap", palette, "-layers", "OptimizeTransparency",
            "-layers", "OptimizeFrame", path,
        )  # fmt: skip
        if path.stat().st_size <= GIF_LIMIT:
            break


def statistics(program, desk_cpu, seconds, profile):
    """What the program says of itself at its end, and what the kernel says of it."""
    texts = [log.read_text(encoding="utf-8", errors="replace") for log in sorted(profile.glob("**/*.log"))]
    own = [line for text in [*texts, program.text()] for line in text.splitlines() if re.search(r"\bframes\b", line)]
    line = f"{100 * desk_cpu / seconds:.0f} % of a core"
    return f"{own[-1].strip()}; {line}" if own else line


def main():
    exe, seconds, folder = Path(sys.argv[1]).resolve(), float(sys.argv[2]), Path(sys.argv[3]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    profile = make_profile(folder / "profile")
    frames_folder = folder / "frames"
    shutil.rmtree(frames_folder, ignore_errors=True)
    frames_folder.mkdir()
    wallpaper = folder / "wallpaper.png"
    subprocess.run(
        ["rsvg-convert", "-w", str(SIZE[0]), "-h", str(SIZE[1]), "-o", str(wallpaper), str(HERE / "wallpaper.svg")],
        check=True,
    )
    print(f"showing {exe.name} on a virtual display for {seconds:g} s", flush=True)
    with desktop.VirtualDesktop([(*SIZE, 0, 0)], wallpaper=str(wallpaper)) as desk:
        empty = desk.screenshot()
        program = desk.start(exe, "--profile", wine.windows_path(profile))
        desktop.wait_for(lambda: desk.screenshot().rgb != empty.rgb or not program.running, 60, "the first pet")
        if not program.running:
            sys.exit(f"error: {exe.name} ended at once: {program.text()}")
        before = sum(thread.cpu for thread in program.threads())
        frames = film(desk, seconds, frames_folder)
        cpu = sum(thread.cpu for thread in program.threads()) - before
        desk.screenshot(folder / "screenshot.png")
        # A second start hands its option to the first one, which then has time to say good-bye.
        desk.start(exe, "--profile", wine.windows_path(profile), "--quit").wait(30)
        program.wait(30)
        told = statistics(program, cpu, seconds, profile)
    print(f"making the picture of {len(frames)} frames", flush=True)
    write_gif(frames, folder / "demo.gif")
    shutil.rmtree(frames_folder)
    for name in ("screenshot.png", "demo.gif"):
        path = folder / name
        print(f"{path} ({path.stat().st_size / 1024:.0f} KiB)")
    print(told)


if __name__ == "__main__":
    main()
