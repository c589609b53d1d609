#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures what pets cost on a desktop and writes docs/desktop_costs.md.

desktop_costs.py hyrax.exe post_message.exe hyrax-bench.exe hyrax-headless hyrax-bench [--seconds N]
                 [--repeat N] [--docs DIR] [--work DIR] [--measure [native] [wine]]

The CSV files go to the working folder; what is not measured again is taken from those that are
there. The text is desktop_costs.md.in, where ${...} stands for a figure or a table.
"""

import argparse
import csv
import datetime
import os
import pathlib
import shutil
import statistics
import string
import subprocess
import sys
import time

from desktop_scenes import ROOT, SCREEN, Headless, OnWine, config, desktop, measure, wine

HERE = pathlib.Path(__file__).resolve().parent
COUNTS = (1, 10, 50, 100, 500)
FAST, SLOW = 60, 25  # frames a second
DENSE = 1000  # so many that a frame finds its pixels in the caches
STILL_AFTER = 26  # seconds until pets that lie on the floor have breathed their last picture
STARTS = 7
FEW = 2  # runs of a moving scene that no goal is about

WORDS = {"flying": "flying", "thrown": "thrown", "floor": "along the floor", "rest": "at rest"}

RENDERERS = {"scalar": "one pixel at a time", "sse2": "SSE2", "avx2": "AVX2", "gdiplus": "GDI+, under Wine"}
MOST_DRAWING = {"sse2": 0.4, "avx2": 0.25}  # ms
DRAWING = {
    "drawn_ms": "drawn",
    "erased_drawn_ms": "all erased, drawn",
    "next_frame_ms": "next frame",
    "cold_ms": "next frame, cold",
    "only_erased_cold_ms": "only erased, cold",
}

INPUTS = (
    *("headless", "headless-start", "headless-drawing"),
    *("wine", "wine-start", "wine-drawing", "machine"),
)

SHIJIMA = 0.29  # core: Shijima-Qt with 100 pets at 25 ticks/s, natively on X; process and X together


def scenes():
    """(pets, state, frames a second)"""
    for pets in COUNTS:
        yield pets, "flying", FAST
    yield 100, "flying", SLOW
    for state in ("thrown", "floor"):
        yield 100, state, FAST
        yield 100, state, SLOW
    for pets in COUNTS:
        yield pets, "rest", FAST


def cores_for_all_frames(row):
    """Of all processes, as if a busy machine had let them draw all their frames."""
    return sum(at_its_rate(row, key[:-5]) for key in row if key.endswith("_core"))


def turns_of(scene, repeat):
    pets, state, _ = scene
    return 1 if state == "rest" else repeat if pets == 100 else min(repeat, FEW)


def measure_scenes(show, options, label, chosen, draw):
    """Each scene so often, with the others and what draw() measures in between; the run that took least, for
    other tenants of the machine only add to what is measured."""
    best = {}
    for turn in range(options.repeat):
        draw()
        for scene in (scene for scene in chosen if turn < turns_of(scene, options.repeat)):
            pets, state, fps = scene
            name = f"{label}-{pets}-{state}-{fps}-{turn}"
            shown = show(options.work / "profiles" / name, config(pets, state, fps))
            try:
                figures = measure(shown, STILL_AFTER if state == "rest" else 3, options.seconds)
            finally:
                shown.end()
            row = {"pets": pets, "state": state, "fps": fps, **figures}
            cores = " ".join(f"{k[:-5]} {v:.4f}" for k, v in row.items() if k.endswith("_core"))
            print(f"   {label}: {pets} {state} at {fps} Hz: {cores}", file=sys.stderr, flush=True)
            best[scene] = min(best.get(scene, row), row, key=cores_for_all_frames)
    write(options.work, label, list(best.values()))


def measure_starts(show, work, label):
    """Seconds from the start of the process to its first frame with a pet."""
    times = []
    for turn in range(STARTS):
        shown = show(work / "profiles" / f"{label}-start-{turn}", config(3, "flying", FAST))
        try:
            time.sleep(1)
            times.append(shown.tell()["first_frame"] - shown.begin)
        finally:
            shown.end()
    return [{"start": statistics.median(times), "fastest": min(times), "slowest": max(times)}]


def write(work, name, rows):
    with (work / f"{name}.csv").open("w", newline="") as file:
        table = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


def read(work, name):
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text

    with (work / f"{name}.csv").open(newline="") as file:
        return [{key: value(text) for key, text in row.items()} for row in csv.DictReader(file)]


class Drawing:
    """What drawing alone takes: each figure is the least of several runs."""

    def __init__(self, options, label, run):
        self._options, self._name, self._run, self._runs = options, f"{label}-drawing", run, []

    def measure(self):
        self._run(self._options.work / f"{self._name}.csv")
        self._runs.append(read(self._options.work, self._name))
        least = [{key: min(row[key] for row in rows) for key in rows[0]} for rows in zip(*self._runs)]
        write(self._options.work, self._name, least)


def measure_native(options):
    def native(folder, settings):
        return Headless(options.headless, folder, settings)

    def compose(file):
        subprocess.run([options.bench, "--csv", file, "compose"], check=True, stdout=subprocess.DEVNULL)

    write(options.work, "headless-start", measure_starts(native, options.work, "headless"))
    chosen = [*scenes(), (100, "hurried", DENSE)]
    measure_scenes(native, options, "headless", chosen, Drawing(options, "headless", compose).measure)


def measure_wine(options):
    # No compositor: its work would not be told apart from that for other windows.
    with desktop.VirtualDesktop([(*SCREEN, 0, 0)], compositor=False) as desk:

        def under_wine(folder, settings):
            return OnWine(desk, options.exe, options.post, folder, settings)

        def compose(file):
            if desk.start(options.bench_exe, "--csv", wine.windows_path(file), "compose").wait(300):
                raise RuntimeError("hyrax-bench.exe does not measure what drawing takes")

        warm = under_wine(options.work / "profiles" / "warm", config(1, "rest", FAST))
        warm.tell()
        warm.end()
        write(options.work, "wine-start", measure_starts(under_wine, options.work, "wine"))
        measure_scenes(under_wine, options, "wine", list(scenes()), Drawing(options, "wine", compose).measure)


PARTS = {"native": measure_native, "wine": measure_wine}


def measure_all(options):
    for part in options.measure:
        shutil.rmtree(options.work / "profiles", ignore_errors=True)
        (options.work / "profiles").mkdir(parents=True)
        PARTS[part](options)
    day = datetime.datetime.now(datetime.timezone.utc).date().isoformat()
    machine = {"cpu": processor(), "cores": os.cpu_count(), "load": os.getloadavg()[2], "day": day}
    write(options.work, "machine", [machine | {"exe": options.exe.stat().st_size}])


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return "unknown processor"


# --- the document ---------------------------------------------------------------------------------


def core(value):
    return f"{value:.4f}" if value < 0.01 else f"{value:.3f}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    lines += ["| " + " | ".join(map(str, row)) + " |" for row in rows]
    return "\n".join(lines)


def costs_table(rows, cores):
    head = ["pets", "frames/s", *[name for name, _ in cores], "presents/s", "MB/s presented", "resizes/s",
            "switches/s", "resident MB", "private MB"]  # fmt: skip
    body = []
    for row in rows:
        body.append([
            f"{row['pets']:.0f} {WORDS[row['state']]}",
            f"{row['frames']:.1f}" + ("" if row["state"] == "rest" else f" of {row['fps']:.0f}"),
            *[core(row[f"{key}_core"]) for _, key in cores],
            f"{row['presents']:.0f}", f"{row['presented_bytes'] / 1e6:.1f}", f"{row['resizes']:.2f}",
            f"{row['switches']:.1f}", f"{row['resident'] / 1e6:.1f}", f"{row['private_bytes'] / 1e6:.1f}",
        ])  # fmt: skip
    return table(head, body)


def one(rows, pets, state, fps=FAST):
    return next(row for row in rows if (row["pets"], row["state"], row["fps"]) == (pets, state, fps))


def at_its_rate(row, key):
    """Core that the process would take if the busy machine had let it draw every frame."""
    return row[f"{key}_core"] * max(1.0, row["fps"] / max(row["frames"], 1e-9))


def goals(data):
    """(goal, limit, measured, met)"""
    native, on_wine, machine = data["headless"], data["wine"], data["machine"][0]
    moving = one(native, 100, "flying")
    resting = [row for rows in (native, on_wine) for row in rows if row["state"] == "rest"]
    woken = max(row["presents"] + row["timer_wakeups"] for row in resting)
    drawn = {row["renderer"]: row["drawn_ms"] for row in data["headless-drawing"]}
    for renderer, most in MOST_DRAWING.items():
        yield (f"a hundred sprites of 128x128 drawn into 1920x1080, {RENDERERS[renderer]}", f"<= {most} ms",
               f"{drawn[renderer]:.2f} ms", drawn[renderer] <= most)  # fmt: skip
    starts = {name: data[f"{name}-start"][0]["start"] for name in ("headless", "wine")}
    for state in ("floor", "thrown", "flying"):
        used = at_its_rate(one(native, 100, state), "process")
        yield (f"engine, planners and composition, 100 pets {WORDS[state]} at 60 Hz, native", "<= 0.02 core",
               f"{core(used)} core", used <= 0.02)  # fmt: skip
    dense = one(native, 100, "hurried", DENSE)
    work = FAST * dense["process_core"] / dense["frames"]
    yield (f"the same, flying, 60 of {DENSE} frames a second in which pets come as far", "<= 0.02 core",
           f"{core(work)} core", work <= 0.02)  # fmt: skip
    yield ("all at rest: presents and timer wake-ups", "0", f"{woken:.1f} a second", woken == 0)
    for state in ("floor", "thrown", "flying"):
        parts = [at_its_rate(one(on_wine, 100, state, SLOW), key) for key in ("process", "wineserver", "X")]
        total = sum(parts)
        yield (f"`hyrax.exe` under Wine, 100 pets {WORDS[state]}, 25 Hz: process + wineserver + X",
               f"< {SHIJIMA} core", f"{total:.3f} core ({' + '.join(core(part) for part in parts)})",
               total < SHIJIMA)  # fmt: skip
    yield ("resident memory, 100 pets of one kind, native", "<= 30 MB", f"{moving['resident'] / 1e6:.1f} MB",
           moving["resident"] <= 30e6)  # fmt: skip
    yield ("process start to first frame, native", "<= 100 ms", f"{1000 * starts['headless']:.0f} ms",
           starts["headless"] <= 0.1)  # fmt: skip
    yield ("process start to first frame, under Wine (its server running)", "<= 400 ms",
           f"{1000 * starts['wine']:.0f} ms", starts["wine"] <= 0.4)  # fmt: skip
    yield ("`hyrax.exe`, stripped, statically linked", "<= 4 MB", f"{machine['exe'] / 1e6:.2f} MB",
           machine["exe"] <= 4e6)  # fmt: skip


def drawing_table(data):
    rows = [*data["headless-drawing"], *(row for row in data["wine-drawing"] if row["renderer"] == "gdiplus")]
    figure = lambda value: "" if value == "" else f"{value:.2f}"
    body = [[RENDERERS[row["renderer"]], *(figure(row[key]) for key in DRAWING)] for row in rows]
    return table(["ms", *DRAWING.values()], body)


def write_document(options):
    data = {name: read(options.work, name) for name in INPUTS}
    machine = data["machine"][0]
    rows = [[goal, limit, measured, "met" if met else "**not met**"] for goal, limit, measured, met in goals(data)]
    text = string.Template((HERE / "desktop_costs.md.in").read_text()).substitute(
        machine=f"{machine['cpu']}, {machine['cores']:.0f} processors, Linux, {machine['day']}; "
        f"the machine's load was {machine['load']:.1f}",
        goals=table(["what", "goal", "measured", ""], rows),
        drawing=drawing_table(data),
        erasing=core(FAST * data["headless-drawing"][0]["only_erased_cold_ms"] / 1000),
        headless=costs_table(
            [row for row in data["headless"] if row["fps"] != DENSE], [("process, core", "process")]
        ),
        wine=costs_table(
            data["wine"], [("process, core", "process"), ("wineserver, core", "wineserver"), ("X, core", "X")]
        ),
    )
    (options.docs / "desktop_costs.md").write_text(text)
    print(f"wrote {options.docs / 'desktop_costs.md'}")


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for program in ("exe", "post", "bench_exe", "headless", "bench"):
        options.add_argument(program, type=lambda text: pathlib.Path(text).resolve())
    options.add_argument("--seconds", type=float, default=6, help="to measure each scene")
    options.add_argument("--repeat", type=int, default=6, help="runs of each moving scene with a hundred pets")
    options.add_argument("--docs", type=pathlib.Path, default=ROOT / "docs")
    options.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "desktop_costs")
    options.add_argument("--measure", nargs="*", choices=PARTS, default=list(PARTS))
    options = options.parse_args()
    if options.measure:
        measure_all(options)
    write_document(options)


if __name__ == "__main__":
    main()
