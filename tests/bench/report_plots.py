# SPDX-License-Identifier: MIT
"""The plots of docs/numerics.md, from the rows of hyrax-bench's CSV files."""

import math

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402
from matplotlib.colors import TwoSlopeNorm  # noqa: E402

DPI = 100
HALF_A_PIXEL = 0.5
SMALLEST = 1e-14  # what a perfect figure is drawn as
# Okabe and Ito's colours, which the colour-blind tell apart, and a mark of its own for each.
LOOKS = {
    "document": ("#D55E00", "o"),
    "semi_implicit_euler": ("#E69F00", "s"),
    "stormer_verlet": ("#009E73", "^"),
    "rk45": ("#CC79A7", "v"),
    "exponential_swept": ("#56B4E9", "D"),
    "event_driven": ("#0072B2", "o"),
}
SHORT = {"DOC": "document", "SIE": "semi_implicit\n_euler (rates)", "SVS": "stormer\n_verlet",
         "RK45": "rk45", "EXPS": "exponential\n_swept", "EXACT": "event\n_driven"}
LABELS = {"semi_implicit_euler": "semi_implicit_euler (rates)"}

pyplot.rcParams.update({
    "font.size": 10, "axes.grid": True, "grid.color": "#dddddd", "axes.axisbelow": True,
    "figure.dpi": DPI, "savefig.dpi": DPI, "axes.spines.top": False, "axes.spines.right": False,
})


def save(figure, folder, name):
    """As PNG, without a date in it."""
    figure.savefig(folder / f"{name}.png", metadata={"Software": None})
    pyplot.close(figure)


def look(method, filled=True):
    """How a method's line looks."""
    colour, marker = LOOKS[method]
    return {"color": colour, "marker": marker, "markersize": 5, "linewidth": 1.4,
            "markerfacecolor": colour if filled else "white", "label": LABELS.get(method, method)}


def work_precision(found, folder, final_error):
    """A panel for each scene."""
    scenes = list(dict.fromkeys(row["scene"] for row in found))
    figure, panels = pyplot.subplots(2, 3, figsize=(12, 8.4), sharey=True)
    for panel, scene in zip(panels.flat, scenes):
        for method in LOOKS:
            line = [row for row in found if row["scene"] == scene and row["method"] == method]
            stepped = [row for row in line if row["rate"] > 0 or method == "rk45"]
            errors = [max(final_error(row), SMALLEST) for row in stepped]
            panel.loglog([row["ns"] for row in stepped], errors, **look(method))
            for row in (row for row in line if method == "event_driven" and row["rate"] == 0):
                panel.loglog([row["ns"]], [max(final_error(row), SMALLEST)], marker="*", color="#0072B2",
                             markersize=15, linestyle="none", label="event_driven, events only")
        panel.axhline(0.5, color="#888888", linewidth=1, linestyle="--")
        panel.set_title(scene, fontweight="bold")
        panel.set_ylim(SMALLEST / 3, 3e4)
    for panel in panels[:, 0]:
        panel.set_ylabel("error of position [px]")
        panel.text(0.02, 0.4, "half a pixel", transform=panel.get_yaxis_transform(), va="top",
                   fontsize=9, color="#666666")
    for panel in panels[1]:
        panel.set_xlabel("ns per simulated second")
    handles, labels = panels[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=4, frameon=False)
    figure.tight_layout(rect=(0, 0.07, 1, 1))
    save(figure, folder, "work_precision")


def frame_rate(found, folder):
    """The way against the frame rate."""
    figure, panel = pyplot.subplots(figsize=(9, 4.8))
    for method in ("event_driven", "semi_implicit_euler", "document"):
        line = [row for row in found if row["method"] == method and row["hz"] > 0]
        panel.semilogx([row["hz"] for row in line], [row["way"] for row in line], **look(method))
    ticks = [24, 60, 144, 240, 1000, 10000, 100000]
    panel.set_xticks(ticks, [f"{tick:,}".replace(",", " ") for tick in ticks])
    panel.minorticks_off()
    panel.set_xlabel("frames per second")
    panel.set_ylabel("way until rest [px]")
    panel.set_ylim(-60, 2150)
    panel.legend(frameon=False, loc="lower left")
    figure.tight_layout()
    save(figure, folder, "frame_rate")


def energy(found, folder):
    """Both frame rates side by side."""
    figure, panels = pyplot.subplots(1, 2, figsize=(11, 4.8), sharey=True)
    for panel, rate in zip(panels, (60, 240)):
        for method in LOOKS:
            line = [row for row in found if row["method"] == method and row["rate"] == rate]
            # The two Eulers are one line, and so are the two exact flights: the lower one is broad.
            width = 5 if method in ("document", "stormer_verlet") else 1.4
            panel.loglog([row["frame"] / rate for row in line],
                         [max(abs(row["relative_error"]), 1e-17) for row in line],
                         color=LOOKS[method][0], linewidth=width, label=LABELS.get(method, method))
        panel.set_title(f"{rate} Hz", fontweight="bold")
        panel.set_xlabel("simulated seconds")
        panel.set_ylim(1e-17, 10)
    panels[0].set_ylabel("relative error of energy")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=3, frameon=False)
    figure.tight_layout(rect=(0, 0.11, 1, 1))
    save(figure, folder, "energy")


def heat(panel, values, texts, failing, columns, lines):
    """Blue passes, red fails; by how many powers of ten."""
    shown = panel.imshow(values, cmap="RdBu_r", norm=TwoSlopeNorm(0, -8, 8), aspect="auto")
    panel.set_xticks(range(len(columns)), columns)
    panel.xaxis.tick_top()
    panel.set_yticks(range(len(lines)), lines)
    panel.tick_params(length=0)
    panel.grid(False)
    for spine in panel.spines.values():
        spine.set_visible(False)
    for y, line in enumerate(texts):
        for x, text in enumerate(line):
            dark = abs(values[y][x]) > 4.5
            panel.text(x, y, text, ha="center", va="center", fontsize=9,
                       fontweight="bold" if failing[y][x] else "normal",
                       color="white" if dark else "black")
    return shown


def digits(value):
    """Two digits in few characters."""
    if not math.isfinite(value):
        return "inf"
    if value == 0:
        return "0"
    return f"{value:.1g}" if abs(value) < 1e-3 else f"{value:.2g}"


def short(value):
    """A figure for a bar: 0.78, 14.9, 1470."""
    if value < 0.1:
        return f"{value:.1g}"
    return f"{value:.2g}" if value < 10 else f"{value:.3g}" if value < 100 else f"{value:.0f}"


def power(value, tolerance):
    """By how many powers of ten a value exceeds what is allowed, from -8 to 8."""
    if not math.isfinite(value):
        return 8.0
    if tolerance == 0:
        return -8.0 if value == 0 else 8.0
    return min(8.0, max(-8.0, math.log10(max(value, 1e-30) / tolerance)))


def stability(found, texts, folder):
    """The catalogue; `texts` says what a case is."""
    cases = list(dict.fromkeys(row["case"] for row in found))
    of = {(row["case"], row["integrator"]): row for row in found}
    lines = [[of[case, short] for short in SHORT] for case in cases]
    values = [[power(row["error"], row["tolerance"]) for row in line] for line in lines]
    # What fails by a hair must not look as if it passed.
    values = [[max(v, 0.6) if row["fails"] else min(v, -0.6) for v, row in zip(line, of_case)]
              for line, of_case in zip(values, lines)]
    figure, panel = pyplot.subplots(figsize=(12, 1.4 + 0.27 * len(cases)))
    heat(panel, values, [[digits(row["error"]) for row in line] for line in lines],
         [[bool(row["fails"]) for row in line] for line in lines], list(SHORT.values()),
         [f"{texts.get(int(case), 'case')}  {case:.0f}" for case in cases])
    figure.tight_layout()
    save(figure, folder, "stability")


def springs(found, folder):
    """Errors, and largest stable steps."""
    errors = [row for row in found if row["quantity"] == "error_px"]
    schemes = list(dict.fromkeys(row["scheme"] for row in errors))
    cases = list(dict.fromkeys(row["case"] for row in errors))
    of = {(row["case"], row["scheme"]): row for row in errors}
    lines = [[of[case, scheme]["value"] for scheme in schemes] for case in cases]
    values = [[power(value, HALF_A_PIXEL) for value in line] for line in lines]
    titles = {"semi-implicit with implicit damping": "semi-implicit,\nimplicit damping"}
    columns = [titles.get(scheme, scheme.replace(" ", "\n")) for scheme in schemes]
    names = [f"{case}: $\\omega$={of[case, schemes[0]]['w']:g}, "
             f"$\\zeta$={of[case, schemes[0]]['damping_ratio']:g}" for case in cases]
    figure, panel = pyplot.subplots(figsize=(11, 4.4))
    heat(panel, values, [[digits(value) for value in line] for line in lines],
         [[v > 0 for v in line] for line in values], columns, names)
    figure.tight_layout()
    save(figure, folder, "springs")


def scene_cost(found, folder):
    """Bars of one group, the longest last."""
    lines = [row for row in found if row["group"] == "frame"]
    figure, panel = pyplot.subplots(figsize=(10, 0.9 + 0.36 * len(lines)))
    places = range(len(lines))
    panel.barh(places, [row["ns"] for row in lines], color="#56B4E9", height=0.7)
    longest = max(row["ns"] for row in lines)
    for place, row in zip(places, lines):
        counted = "" if math.isnan(row["instructions"]) else f", {short(row['instructions'])} instructions"
        panel.text(row["ns"] + longest * 0.01, place, f"{short(row['ns'])} ns{counted}", va="center")
    panel.set_yticks(places, [row["case"] for row in lines])
    panel.invert_yaxis()
    panel.grid(False, axis="y")
    panel.set_xlim(0, longest * 1.5)
    panel.set_xlabel("ns per pet and frame")
    figure.tight_layout()
    save(figure, folder, "scene_cost")


def throughput(found, folder):
    """Nanoseconds against the number of pets."""
    figure, panel = pyplot.subplots(figsize=(9, 4.8))
    colours = ["#D55E00", "#E69F00", "#009E73", "#0072B2", "#CC79A7", "#888888"]
    kernels = list(dict.fromkeys(row["kernel"] for row in found))
    for colour, marker, kernel in zip(colours[: len(kernels)], "osv^D*", kernels):
        line = [row for row in found if row["kernel"] == kernel]
        panel.loglog([row["pets"] for row in line], [row["ns_per_pet_and_step"] for row in line],
                     color=colour, marker=marker, label=kernel)
    panel.set_xlabel("pets")
    panel.set_ylabel("ns per pet and step")
    panel.legend(frameon=False, ncol=2)
    figure.tight_layout()
    save(figure, folder, "throughput")


def peers(found, folder):
    """Groups of bars."""
    engines = list(dict.fromkeys(row["engine"] for row in found))
    sizes = list(dict.fromkeys(row["bodies"] for row in found))
    colours = ["#0072B2", "#E69F00", "#D55E00", "#009E73", "#CC79A7", "#56B4E9"]
    figure, panel = pyplot.subplots(figsize=(9, 4.8))
    width = 0.8 / len(engines)
    for i, (engine, colour) in enumerate(zip(engines, colours[: len(engines)], strict=True)):
        line = [row for row in found if row["engine"] == engine]
        places = [x + (i - (len(engines) - 1) / 2) * width for x in range(len(sizes))]
        heights = [row["ns_per_body_and_step"] for row in line]
        panel.bar(places, heights, width * 0.92, color=colour, label=engine)
        for place, height in zip(places, heights):
            panel.text(place, height * 1.06, short(height), ha="center", fontsize=8)
    panel.set_yscale("log")
    panel.set_ylim(0.1, 1e5)
    panel.set_xticks(range(len(sizes)), [f"{size:.0f} bodies" for size in sizes])
    panel.grid(False, axis="x")
    panel.set_ylabel("ns per body and step")
    panel.legend(frameon=False, ncol=2, loc="upper left")
    figure.tight_layout()
    save(figure, folder, "peers")


def draw(data, case_texts, folder, final_error):
    """All of them."""
    work_precision(data["work-precision"], folder, final_error)
    stability(data["stability"], case_texts, folder)
    energy(data["energy"], folder)
    frame_rate(data["frame-rate"], folder)
    springs(data["springs"], folder)
    scene_cost(data["scene-cost"], folder)
    throughput(data["throughput"], folder)
    peers(data["peers"], folder)
