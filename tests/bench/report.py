#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs hyrax-bench and writes docs/numerics.md with its plots from what comes out.

report.py <hyrax-bench> [--docs DIR] [--work DIR] [--keep] [--quick]

The CSV files go to the working folder; --keep takes those that are there instead of measuring
again. The text is numerics.md.in, where ${...} stands for a figure or a table. Wants matplotlib.
"""

import argparse
import csv
import datetime
import math
import os
import pathlib
import platform
import string
import subprocess
import sys
import time

import report_plots

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
METHODS = ("document", "semi_implicit_euler", "stormer_verlet", "rk45", "exponential_swept",
           "event_driven")
# Columns of the catalogue in the order of METHODS.
SHORT = ("DOC", "SIE", "SVS", "RK45", "EXPS", "EXACT")
COUNTING = ("work-precision", "scene-cost")
TIMED = {"work-precision": 0.05, "scene-cost": 0.3, "throughput": 0.3, "peers": 0.5}
BENCHES = ("work-precision", "stability", "energy", "frame-rate", "springs", "throughput",
           "scene-cost", "peers")
USED_RATE = 60  # [1/s]
HALF_A_PIXEL = 0.5


def measure(program, work, quick):
    """Runs every subcommand; its progress goes to our stderr."""
    begin = time.monotonic()
    for bench in BENCHES:
        command = [program, bench, "--csv", work / f"{bench}.csv"]
        if bench in TIMED:
            command += ["--seconds-per-cell", str(TIMED[bench] / (20 if quick else 1))]
        if bench in COUNTING:
            command.append("--count-instructions")
        print(f"== {bench}", file=sys.stderr, flush=True)
        with (work / f"{bench}.txt").open("w") as table:
            subprocess.run(command, stdout=table, check=True)
    seconds = time.monotonic() - begin
    (work / "machine.txt").write_text(machine(seconds))


def machine(seconds):
    """Where and when the figures were measured."""
    model = platform.processor() or platform.machine()
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                model = line.split(":", 1)[1].strip()
                break
    except OSError:
        pass
    day = datetime.datetime.now(datetime.timezone.utc).date().isoformat()
    return (f"{model}, {os.cpu_count()} processors, {platform.system()} {platform.machine()}, {day}; "
            f"{seconds / 60:.1f} minutes on one core")


def rows(work, bench):
    """The lines of a CSV file as dictionaries; numbers become numbers."""
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text
    with (work / f"{bench}.csv").open(newline="") as file:
        return [{key: value(text) for key, text in row.items()} for row in csv.DictReader(file)]


def number(value, digits=2):
    """A figure for a table: 0.0031, 14, 1.2e-13, 1500."""
    if value is None or math.isnan(value):
        return "-"
    if value == 0:
        return "0"
    if math.isinf(value):
        return "inf"
    size = math.floor(math.log10(abs(value)))
    if size < -3 or size > 6:
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        return f"{mantissa}e{int(exponent)}"
    return f"{round(value, digits - 1 - size):.{max(0, digits - 1 - size)}f}"


def case_texts(work):
    """What each case of the catalogue is, from its table."""
    texts = {}
    for line in (work / "stability.txt").read_text().splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) > 2 and cells[1].isdigit():
            texts[int(cells[1])] = cells[2]
    return texts


def table(head, lines):
    """Markdown."""
    cells = [head, ["---"] * len(head), *lines]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in cells)


def final_error(row):
    """At rest if the scene comes to rest, else at the end of what is timed."""
    if row["scene"] == "stiff drag":
        return row["error_1"]
    return row["error_5"] if math.isnan(row["error_rest"]) else row["error_rest"]


def variant(row):
    """The integrator, and how it is read."""
    return "event_driven, events only" if row["method"] == "event_driven" and row["rate"] == 0 \
        else row["method"]


def at_60_hz(precision):
    """Error / nanoseconds / instructions for each scene and integrator."""
    scenes = list(dict.fromkeys(row["scene"] for row in precision))
    lines = []
    for name in [*METHODS, "event_driven, events only"]:
        cells = [f"`{name}`" if "," not in name else name]
        for scene in scenes:
            row = next(row for row in precision
                       if row["scene"] == scene and variant(row) == name
                       and (row["rate"] in (0, USED_RATE))
                       and (name != "rk45" or math.isclose(row["tolerance"], 1e-6, rel_tol=1e-6)))
            cells.append(f"{number(final_error(row))} / {number(row['ns'], 3)}")
        lines.append(cells)
    return table(["error px / ns per simulated second", *scenes], lines)


def document_scene(precision):
    """All samples of one scene."""
    lines = []
    for row in precision:
        if row["scene"] != "document":
            continue
        if row["method"] == "rk45":
            if not any(math.isclose(row["tolerance"], t, rel_tol=1e-6) for t in (1e-6, 1e-9, 1e-12)):
                continue
            step = f"tolerance {row['tolerance']:.0e}"
        elif row["rate"] in (0, 60, 240, 15360):
            step = "events only" if row["rate"] == 0 else f"1/{row['rate']:.0f} s"
        else:
            continue
        lines.append([f"`{row['method']}`", step,
                      *(number(row[f"error_{at}"]) for at in ("1", "2", "5", "rest")),
                      number(row["ns"], 3), number(row["instructions"], 3)])
    return table(["integrator", "step", "1 s", "2 s", "5 s", "rest", "ns/s", "instructions/s"], lines)


def half_a_pixel(precision):
    """The cheapest setting of each integrator within half a pixel."""
    scenes = list(dict.fromkeys(row["scene"] for row in precision))
    lines = []
    for name in [*METHODS, "event_driven, events only"]:
        cells = [f"`{name}`" if "," not in name else name]
        for scene in scenes:
            fit = [row for row in precision
                   if row["scene"] == scene and variant(row) == name
                   and max(e for e in (row["error_1"], row["error_2"], row["error_5"],
                                       final_error(row)) if not math.isnan(e)) <= HALF_A_PIXEL]
            best = min(fit, key=lambda row: row["ns"], default=None)
            if best is None:
                cells.append("never")
            elif best["method"] == "rk45" or best["rate"] == 0:
                cells.append(number(best["ns"], 3))
            else:
                cells.append(f"{number(best['ns'], 3)} @{best['rate']:.0f}")
        lines.append(cells)
    return table(["ns per simulated second @Hz", *scenes], lines)


def frame_rates(found):
    """Peaks and way for the document and the default."""
    lines = []
    for row in (row for row in found if row["method"] == "document"):
        ours = next(r for r in found if r["method"] == "event_driven" and r["pace"] == row["pace"])
        lines.append([row["pace"], *(f"{row[f'peak_{i}']:.1f}" for i in (1, 2, 3)),
                      f"{row['way']:.1f}", f"{row['error']:+.1f}", f"{ours['way']:.3f}",
                      number(abs(ours["error"]))])
    return table(["frames", "peak 1", "peak 2", "peak 3", "document: way px", "off by px",
                  "event_driven: way px", "off by px"], lines)


def energies(found):
    """After the last frame."""
    last = {}
    for row in found:
        last[row["method"], row["rate"]] = row["relative_error"]
    return table(["integrator", "60 Hz", "240 Hz"],
                 [[f"`{name}`", *(f"{last[name, rate]:+.1e}" for rate in (60, 240))] for name in METHODS])


def failures(found):
    """How many cases each integrator fails, and the cases that are not of the document alone."""
    cases = list(dict.fromkeys(row["case"] for row in found))
    failed = {name: [int(row["case"]) for row in found if row["integrator"] == name and row["fails"]]
              for name in SHORT}
    lines = [[f"`{name}`", f"{len(failed[short])} of {len(cases)}",
              ", ".join(map(str, failed[short])) or "none"] for name, short in zip(METHODS, SHORT)]
    return table(["integrator", "fails", "cases"], lines), failed, len(cases)


def spring_table(found):
    """Errors for each case and scheme."""
    errors = [row for row in found if row["quantity"] == "error_px"]
    schemes = list(dict.fromkeys(row["scheme"] for row in errors))
    lines = []
    for case in dict.fromkeys(row["case"] for row in errors):
        of = {row["scheme"]: row for row in errors if row["case"] == case}
        first = of[schemes[0]]
        lines.append([f"{case}: w={first['w']:g}, zeta={first['damping_ratio']:g}",
                      *(number(of[scheme]["value"]) for scheme in schemes)])
    return table(["px", *schemes], lines)


def scene_costs(found):
    """One table, three groups."""
    titles = {"frame": "**a pet and frame, `Trajectory`**", "body": "**a pet and frame, `Body`**",
              "event": "**one event**"}
    lines = []
    for group, title in titles.items():
        lines.append([title, "", ""])
        lines += [[row["case"], number(row["ns"], 3), number(row["instructions"], 3)]
                  for row in found if row["group"] == group]
    return table(["", "ns", "instructions"], lines)


def throughputs(found):
    """Nanoseconds for each number of pets and kernel."""
    kernels = list(dict.fromkeys(row["kernel"] for row in found))
    lines = []
    for pets in dict.fromkeys(row["pets"] for row in found):
        of = {row["kernel"]: row for row in found if row["pets"] == pets}
        lines.append([f"{pets:.0f}", *(
            number(of[k]["ns_per_pet_and_step"]) + f" ({of[k]['times_as_fast_as_class']:.1f}x)"
            for k in kernels)])
    return table(["pets", *kernels], lines)


def peer_table(found):
    """Nanoseconds for each number of bodies and engine."""
    engines = list(dict.fromkeys(row["engine"] for row in found))
    lines = []
    for bodies in dict.fromkeys(row["bodies"] for row in found):
        of = {row["engine"]: row for row in found if row["bodies"] == bodies}
        lines.append([f"{bodies:.0f}", *(
            number(of[e]["ns_per_body_and_step"], 3) + f" ({number(of[e]['times_event_driven'])}x)"
            for e in engines)])
    return table(["bodies", *engines], lines)


def best_engine(found):
    """The quickest general engine at 1000 bodies, in words."""
    others = [row for row in found if row["bodies"] == 1000 and not row["engine"].startswith("hyrax")]
    if not others:
        return "No general engine was built in."
    best = min(others, key=lambda row: row["times_event_driven"])
    return (f"With 1000 bodies the quickest of them, {best['engine']}, takes "
            f"{best['times_event_driven']:.0f} times as long as `event_driven`.")


def aims(data):
    """What the physics set out to reach, and what this run says of it."""
    def kernel(name):
        return next((row for row in data["throughput"] if row["pets"] == 10000 and row["kernel"] == name), None)

    asleep = next(row for row in data["scene-cost"] if row["case"] == "asleep, on no list")
    lines = [["all pets at rest, whatever their number, a frame", "10 ns", f"0, and {number(asleep['ns'], 1)} ns a pet to skip it"]]
    for name in ("avx2", "avx512"):
        if row := kernel(name):
            lines.append([f"the document's step, 10 000 pets, {name}", "0.5 ns, 4 times the class",
                          f"{number(row['ns_per_pet_and_step'], 2)} ns, {row['times_as_fast_as_class']:.1f} times"])
    others = [row for row in data["peers"] if row["bodies"] == 1000 and not row["engine"].startswith("hyrax")]
    for row in sorted(others, key=lambda row: row["times_event_driven"])[:1]:
        lines.append([f"1000 pets in flight against the quickest engine ({row['engine']})", "25 times",
                      f"{row['times_event_driven']:.0f} times"])
    lines.append(["collisions of pets with each other", "60 ns", "left out: pets pass through each other"])
    return table(["", "aim", "measured"], lines)


def figures(data):
    """What the template names."""
    precision = data["work-precision"]

    def cell(scene, name, rate=USED_RATE):
        return next(row for row in precision if row["scene"] == scene and variant(row) == name
                    and row["rate"] == rate)

    document, ours = cell("document", "document"), cell("document", "event_driven")
    events = cell("document", "event_driven, events only", 0)
    ours_everywhere = [row for row in precision if row["method"] == "event_driven"]
    euler = min((row for row in precision if row["scene"] == "document"
                 and row["method"] == "semi_implicit_euler" and row["error_rest"] <= HALF_A_PIXEL),
                key=lambda row: row["ns"])
    failure_table, failed, cases = failures(data["stability"])
    counted = not math.isnan(ours["instructions"])
    cost = "instructions" if counted else "ns"
    return {
        "at_60_hz": at_60_hz(precision), "document_scene": document_scene(precision),
        "half_a_pixel": half_a_pixel(precision), "frame_rates": frame_rates(data["frame-rate"]),
        "energies": energies(data["energy"]), "failures": failure_table, "cases": cases,
        "document_fails": len(failed["DOC"]), "exact_fails": len(failed["EXACT"]) or "none",
        "springs": spring_table(data["springs"]), "scene_costs": scene_costs(data["scene-cost"]),
        "throughputs": throughputs(data["throughput"]), "peers": peer_table(data["peers"]),
        "best_engine": best_engine(data["peers"]), "aims": aims(data),
        "document_error": number(document["error_rest"]),
        "document_error_240": number(cell("document", "document", 240)["error_rest"], 3),
        "worst_exact": number(max(max(row["error_1"], row["error_2"], row["error_5"])
                                  for row in ours_everywhere)),
        "ratio_frames": number(ours[cost] / document[cost]),
        "ratio_events": number(events[cost] / document[cost]),
        "euler_rate": f"{euler['rate']:.0f}", "ratio_euler": number(euler[cost] / ours[cost]),
        "cost_unit": cost,
    }


def main():
    """Measures, draws, writes."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--docs", type=pathlib.Path, default=ROOT / "docs")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "numerics")
    parser.add_argument("--keep", action="store_true", help="do not measure again")
    parser.add_argument("--quick", action="store_true", help="rough figures in about a minute")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    if not arguments.keep:
        measure(arguments.program.resolve(), arguments.work, arguments.quick)
    data = {bench: rows(arguments.work, bench) for bench in BENCHES}
    pictures = arguments.docs / "numerics"
    pictures.mkdir(parents=True, exist_ok=True)
    report_plots.draw(data, case_texts(arguments.work), pictures, final_error)
    template = string.Template((HERE / "numerics.md.in").read_text())
    machine_text = (arguments.work / "machine.txt").read_text()
    text = template.substitute(figures(data), machine=machine_text)
    (arguments.docs / "numerics.md").write_text(text)
    print(f"wrote {arguments.docs / 'numerics.md'}")


if __name__ == "__main__":
    main()
