# SPDX-License-Identifier: MIT
"""hyrax.exe for a long time, under Wine: memory, descriptors and objects must stay what they were.

Usage: test_soak.py hyrax.exe post_message.exe [--minutes N] [--debug CHANNELS]

22 pets fly, a script spawns and removes others, the config is saved again and again, and changes of
the screens are announced in storms. What is held is read while all pets are hidden, so that no window
counts: those come and go as pets meet and part. `--debug +seh` keeps what Wine says of exceptions.
"""

import argparse
import re
import sys
import time
from pathlib import Path

import desktop
from daemon import Daemon
from program import footprint

PETS = 22
MOST_SAMPLES = 24
SECONDS_BETWEEN = 6  # at least: a sample starts programs, which takes one or two
MOST_GROWTH = 1e6  # bytes, from one half to the other
WM_DISPLAYCHANGE = 0x7E

SCRIPT = """
hyrax.every(0.5, function()
    local mine = hyrax.pets{ tag = "guest" }
    if #mine > 4 then mine[1]:remove() end
    local pet = hyrax.spawn{ x = math.random(0, 1000), y = math.random(0, 500), tag = "guest" }
    pet:fling(math.random(-600, 600), math.random(-800, 0))
end)
"""


def config(number):
    physics = {"gravity": 900 + 10 * (number % 7), "restitution": 1, "air_drag": 1, "ground_friction": 1}
    pet = {"count": PETS, "x": 300, "y": 100, "vx": 250}
    return {"physics": physics, "pets": {"start": [pet], "max": 60}}


def sample(desk, daemon, post):
    told = daemon.statistics(post)
    server = next(pid for pid, line in desk.processes() if "wineserver" in line.split()[0])
    return {
        **{key: told[key] for key in ("frames", "gdi_objects", "user_objects", "handles", "private_bytes", "failures")},
        **footprint(daemon.program.pid),
        **{f"server_{key}": value for key, value in footprint(server).items()},
    }


def sample_without_windows(desk, daemon, post):
    daemon.second_start("--hide")
    desktop.wait_for(lambda: not desk.windows("hyrax pane"), 20, "the panes to go")
    taken = sample(desk, daemon, post)
    daemon.second_start("--show")
    desktop.wait_for(lambda: desk.windows("hyrax pane"), 20, "the panes to come back")
    return taken


def soak(desk, options):
    scripts, environment = {"guests.lua": SCRIPT}, {"WINEDEBUG": options.debug}
    daemon = Daemon(desk, options.exe, config(0), scripts, trace=False, env=environment)
    samples, saves, begin = [], 0, time.monotonic()
    count = max(8, min(MOST_SAMPLES, int(options.minutes * 60 / SECONDS_BETWEEN)))
    while len(samples) < count:
        due = begin + options.minutes * 60 * (len(samples) + 1) / count
        while time.monotonic() < due:
            saves += 1
            daemon.write_config(config(saves))
            time.sleep(0.7)  # more than the quiet that the watch waits for
            if not daemon.program.running:
                raise AssertionError(f"ended early: {daemon.program.text()[-2000:]}")
        for _ in range(3):
            desk.start(options.post, "hyrax.daemon", str(WM_DISPLAYCHANGE)).wait(60)
        samples.append(sample_without_windows(desk, daemon, options.post))
    daemon.second_start("--quit")
    code = daemon.program.wait(60)
    return samples, saves, code, daemon.log_text(), daemon.program.text()


def judge(samples):
    """What has grown: lines of text. Some is held for a moment only, so that the least of each half is
    what counts."""
    half = len(samples) // 2
    problems = []
    for key, first in samples[0].items():
        values = [one[key] for one in samples]
        early, late = min(values[:half]), min(values[half:])
        print(f"   {key}: {first} first; at least {early} in the first half, {late} in the second one")
        limit = MOST_GROWTH if key in ("resident", "anonymous", "private_bytes") else 2
        if key not in ("frames", "server_resident", "server_anonymous") and late - early > limit:
            problems.append(f"{key} grew from {early} to {late}")
    return problems


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("exe", type=lambda text: Path(text).resolve())
    options.add_argument("post", type=lambda text: Path(text).resolve())
    options.add_argument("--minutes", type=float, default=1.0)
    options.add_argument("--debug", default="-all")
    options = options.parse_args()
    with desktop.VirtualDesktop([(1280, 720, 0, 0)]) as desk:
        samples, saves, code, log, said = soak(desk, options)
    problems = judge(samples)
    print(f"{options.minutes:g} minutes, {samples[-1]['frames']} frames, {saves} saved configs; exit code {code}")
    if code != 0 or "bye" not in log:
        problems.append(f"it ended with {code}; its log: {log[-500:]}; it said: {said[-4000:]}")
    if re.search(r" (error|critical): ", log):
        problems.append(f"errors in the log: {log[-1000:]}")
    if "Unhandled" in said or "page fault" in said:
        problems.append(f"it said: {said[-4000:]}")
    sys.exit("\n".join(problems) or 0)


if __name__ == "__main__":
    main()
