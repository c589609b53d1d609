#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes box.csv and arena.csv: motions of a point solved to 50 digits, for the tests of physics/.

One row is one sample of one scene: its input (shortest text of each double), the time, then place,
velocity, mode and number of events up to that time. `--check FILE...` solves every n-th scene of
such files again with 40 digits more and compares. Needs mpmath. Takes a few minutes on one core.
"""

import argparse
import csv
import dataclasses
import itertools
import math
import pathlib
import random
import sys

import mpmath

import exact_model
from exact_model import GROUND, Ledge, Obstacle, Scene

HERE = pathlib.Path(__file__).resolve().parent
COLUMNS = ("scene family k c G beta mu eps eps_x x0 y0 vx0 vy0 obstacles t_ns "
           "x y vx vy mode events").split()
INPUTS = [field.name for field in dataclasses.fields(Scene) if field.name not in ("obstacles", "ledges")]
PRINTED_DIGITS = 25
NOTHING = 1e-200  # printed as 0: not every reader takes numbers below the smallest double
SECOND = 10 ** 9  # [ns]
INF = math.inf
LAW = {"k": -60 * math.log(0.999), "c": -60 * math.log(0.8), "G": 1200.0, "beta": 0.6, "mu": 0.8,
       "eps": 5.0, "eps_x": 5.0}


class Draw:
    """Reproducible random numbers; uses only the generator's raw output."""

    def __init__(self, name):
        self.random = random.Random("hyrax " + name)

    def between(self, low, high, decimals=2):
        """An even number between low and high with few decimals."""
        return round(low + (high - low) * self.random.random(), decimals)

    def scale(self, low, high):
        """A number between low and high, even in its logarithm, with 4 digits."""
        return float(f"{low * (high / low) ** self.random.random():.3e}")

    def place(self, low, high):
        """A multiple of 1/64 strictly between low and high."""
        steps = int((high - low) * 64) - 1
        return low + (1 + int(self.random.random() * steps)) / 64

    def pick(self, choices):
        """One of the choices."""
        return choices[int(self.random.random() * len(choices))]

    def velocity(self, low, high):
        """A velocity in any direction whose size is even in its logarithm."""
        angle, speed = 2 * math.pi * self.random.random(), self.scale(low, high)
        return round(speed * math.cos(angle), 2), round(speed * math.sin(angle), 2)


# One box: (left, top, right, bottom) of the places of the point's corner.

BOXES = [(0, 0, 1792, 952), (0, 0, 672, 472), (-1920, -180, -128, 772), (1280, 0, 2496, 656),
         (-640, -1024, 1152, -128)]


def walls(box):
    """The four half planes around a box."""
    left, top, right, bottom = box
    return (Obstacle(-INF, -INF, left, INF), Obstacle(right, -INF, INF, INF),
            Obstacle(-INF, -INF, INF, top), Obstacle(-INF, bottom, INF, INF))


def in_box(draw, box, velocity, **law):
    """A scene that starts in the box; now and then on its floor or at a wall."""
    left, top, right, bottom = box
    x, y = draw.place(left, right), draw.place(top, bottom)
    vx, vy = velocity
    start = draw.random.random()
    if start < 0.10:
        y, vy = float(bottom), 0.0
    elif start < 0.15:
        y = float(bottom)
    elif start < 0.20:
        x = float(draw.pick((left, right)))
    return Scene(**{**LAW, **law}, x0=x, y0=y, vx0=vx, vy0=vy, obstacles=walls(box))


def bouncy(draw):
    """Other restitution and friction than the document's."""
    return {"beta": draw.between(0.3, 0.9), "mu": draw.between(0.5, 1), "eps": draw.pick((5.0, 20.0)),
            "eps_x": draw.pick((5.0, 1.0))}


def document(draw, index):
    if index == 0:
        return Scene(**LAW, x0=100.0, y0=0.0, vx0=600.0, vy0=0.0, obstacles=walls(BOXES[0])), 5 * SECOND
    speed = draw.velocity(50, 4000)
    return in_box(draw, BOXES[0] if index % 2 else draw.pick(BOXES), speed), (5 if index % 5 else 1) * SECOND


def no_drag(draw, index):
    law = {**bouncy(draw), **({"beta": 0.0} if index == 7 else {"mu": 0.0} if index == 8 else {})}
    return in_box(draw, draw.pick(BOXES), draw.velocity(50, 3000), **{**law, "k": 0.0}), 5 * SECOND


def tiny_drag(draw, index):
    law = {**bouncy(draw), "k": draw.scale(1e-16, 1e-6)}
    return in_box(draw, draw.pick(BOXES), draw.velocity(50, 3000), **law), 5 * SECOND


def stiff_drag(draw, index):
    law = {**bouncy(draw), "k": draw.scale(1, 1e4), "G": draw.scale(1e3, 1e6)}
    duration = draw.pick((SECOND // 2, 2 * SECOND, 5 * SECOND))
    return in_box(draw, draw.pick(BOXES), draw.velocity(100, 1e4), **law), duration


def fling(draw, index):
    law = {"beta": draw.between(0.3, 0.7), "mu": draw.between(0.5, 1)}
    return in_box(draw, draw.pick(BOXES), draw.velocity(2e3, 1e7), **law), 5 * SECOND


def elastic(draw, index):
    law = {"k": 0.0, "c": 0.0, "beta": 1.0, "mu": 1.0}
    return in_box(draw, draw.pick(BOXES), draw.velocity(100, 2000), **law), 20 * SECOND


def elastic_drag(draw, index):
    law = {"k": draw.scale(0.01, 0.5), "c": draw.pick((0.0, LAW["c"])), "beta": 1.0, "mu": 1.0}
    return in_box(draw, draw.pick(BOXES), draw.velocity(100, 2000), **law), 20 * SECOND


def strong_gravity(draw, index):
    law = {"G": draw.scale(1e4, 1e9), "beta": draw.between(0.3, 0.8), "mu": draw.between(0.5, 1)}
    scene = in_box(draw, BOXES[0], draw.velocity(50, 3000), **law)
    fall = math.sqrt(2 * 952 / scene.G)
    return scene, 5 * int(draw.between(2, 8) * fall * SECOND / 5)


def no_gravity(draw, index):
    law = {**bouncy(draw), "G": 0.0, "k": draw.pick((0.0, LAW["k"], draw.scale(0.5, 9)))}
    return in_box(draw, draw.pick(BOXES), draw.velocity(50, 2000), **law), 5 * SECOND


def grazing(draw, index):
    """A throw whose apex misses or passes the ceiling by a relative 1e-14 .. 1e-3."""
    scene = in_box(draw, BOXES[0], (draw.between(-800, 800), -1.0), k=0.0 if index % 2 else LAW["k"])
    height = scene.y0 * (1 + draw.pick((-1, 1)) * draw.scale(1e-14, 1e-3))

    def missing(speed):
        motion = exact_model.Motion(dataclasses.replace(scene, vy0=-float(speed)), 1)
        motion.state = dataclasses.replace(motion.state, vy=-speed)
        return scene.y0 - motion.after(motion.apex()).y - height

    with mpmath.workdps(60):
        speed = mpmath.findroot(missing, math.sqrt(2 * scene.G * height))
    return dataclasses.replace(scene, vy0=-float(speed)), 5 * SECOND


def corners(draw, index):
    """A wall is reached at the moment of a floor or a ceiling: exactly, or with drag nearly."""
    left, top, right, bottom = BOXES[index % 2]
    while True:
        time = draw.pick(range(2, 17)) / 16
        vx, vy = draw.pick(range(-1500, 1501)), draw.pick(range(-1500, 900))
        scene = Scene(**{**LAW, "k": 0.0}, x0=(right if vx > 0 else left) - vx * time,
                      y0=(bottom if vy + 1200 * time > 0 else top) - vy * time - 600 * time * time,
                      vx0=float(vx), vy0=float(vy), obstacles=walls(BOXES[index % 2]))
        if vx and left < scene.x0 < right and top < scene.y0 < bottom:
            first = exact_model.solve(scene, [SECOND])[1][:2]
            if len(first) == 2 and first[0].time == first[1].time:
                break
    if index % 3 == 2:
        with mpmath.workdps(60):
            scene = dataclasses.replace(scene, k=LAW["k"])
            motion = exact_model.Motion(dataclasses.replace(scene, vx0=1.0), 1)
            motion.state = dataclasses.replace(motion.state, mode=exact_model.AIR)
            meeting = (motion.floor(mpmath.mpf(9)) if vy + 1200 * time > 0 else motion.ceiling(mpmath.mpf(9)))
            if meeting is not None:
                reach = motion.after(meeting[0]).x - scene.x0
                scene = dataclasses.replace(scene, vx0=float(vx * time / reach))
    return scene, 5 * SECOND


def indifferent(scene, times):
    """Whether a scene with a corner gives the same result when either side comes first."""
    results = [exact_model.solve(dataclasses.replace(scene, x0=scene.x0 + shift), times)[0]
               for shift in (-2.0 ** -24, 0.0, 2.0 ** -24)]
    return all(a.events == b.events and a.state.mode == b.state.mode
               and abs(a.state.x - b.state.x) + abs(a.state.y - b.state.y) < 1e-4
               for a, b in itertools.chain(zip(results[0], results[1]), zip(results[1], results[2])))


FAMILIES = [(document, 100), (no_drag, 30), (tiny_drag, 30), (stiff_drag, 30), (fling, 30), (elastic, 20),
            (elastic_drag, 15), (strong_gravity, 20), (no_gravity, 20), (grazing, 20), (corners, 20)]
ACCEPTED_DOUBTS = {grazing: {"side"}, corners: {"tie"}}


def sample_times(duration):
    """[ns] when a motion is sampled."""
    return [duration // 5, duration * 2 // 5, duration]


def box_scenes():
    """(family, scene, times, samples) of box.csv."""
    for make, count in FAMILIES:
        draw, accepted, made = Draw(make.__name__), ACCEPTED_DOUBTS.get(make, set()), 0
        while made < count:
            scene, duration = make(draw, made)
            times = sample_times(duration)
            samples, _, doubts = exact_model.solve(scene, times)
            if set(doubts) <= accepted and (make is not corners or indifferent(scene, times)):
                made += 1
                yield make.__name__, scene, times, samples
        progress(f"{make.__name__}: {made}")


# Several monitors: each layout is the list of their rectangles (x, y, width, height).

LAYOUTS = {
    "l_shape": [(0, 0, 1920, 1080), (0, 1080, 1280, 1024)],
    "t_shape": [(-1280, 0, 1280, 800), (0, 0, 1280, 800), (1280, 0, 1024, 800), (0, 800, 1280, 720)],
    "stairs": [(0, 0, 800, 600), (800, 200, 800, 600), (1600, 440, 900, 600)],
    "heights": [(-1280, -144, 1280, 1024), (0, 0, 1920, 1080), (1920, 300, 1366, 768)],
    "bridge": [(0, 0, 1000, 800), (1130, 60, 1000, 740), (0, 800, 2130, 500)],
    "negative": [(-3840, -1080, 1920, 1080), (-1920, -540, 1920, 1080), (0, -360, 1280, 800)],
    "level": [(-1920, 0, 1920, 1080), (0, 0, 1920, 1080)],
    "podium": [(0, 0, 900, 700), (900, -100, 500, 600), (1400, 0, 900, 700), (-800, 150, 800, 700)],
    "five": [(0, 0, 1280, 720), (1280, -200, 1024, 768), (2304, 120, 1280, 720), (600, 720, 1280, 720),
             (-1024, 200, 1024, 768)],
}
BODIES = [(64, 64), (128, 128), (128, 96)]
WANTED = ["portal", "step", "edge", "step wall", "over the step", "lintel", ""]


def bounding_box(monitors):
    """(left, top, right, bottom) around all monitors."""
    return (min(m[0] for m in monitors), min(m[1] for m in monitors),
            max(m[0] + m[2] for m in monitors), max(m[1] + m[3] for m in monitors))


def complement(monitors):
    """The part of the bounding box that no monitor covers, in upright slabs (left, top, right, bottom)."""
    _, top, _, bottom = bounding_box(monitors)
    edges = sorted({m[0] for m in monitors} | {m[0] + m[2] for m in monitors})
    for left, right in itertools.pairwise(edges):
        y = top
        for m in sorted(monitors, key=lambda m: m[1]):
            if m[0] < right and m[0] + m[2] > left:
                if m[1] > y:
                    yield left, y, right, m[1]
                y = max(y, m[1] + m[3])
        if y < bottom:
            yield left, y, right, bottom


def arena(monitors, body):
    """The obstacles of the upper left corner of a body that must lie within the monitors."""
    width, height = body
    left, top, right, bottom = bounding_box(monitors)
    solids = [Obstacle(a - width, b - height, c, d) for a, b, c, d in complement(monitors)]
    return walls((left, top, right - width, bottom - height)) + tuple(solids)


def in_arena(draw, monitors, body):
    """A scene that starts in one of the monitors, or on the ground."""
    obstacles = arena(monitors, body)
    left, top, right, bottom = bounding_box(monitors)
    law = draw.pick([{}] * 7 + [{"k": 0.0}, bouncy(draw), {"c": 1.0}])
    steps = [o for o in obstacles if all(map(math.isfinite, o))]
    while True:
        x, y = draw.place(left, right), draw.place(top, bottom)
        vx, vy = draw.between(-1800, 1800), draw.between(-1500, 700)
        if steps and draw.random.random() < 0.35:
            step, run_up = draw.pick(steps), draw.place(0, 90)
            x, y, vy = step.left + run_up if vx < 0 else step.right - run_up, step.top, 0.0
        if not any(o.left <= x <= o.right and o.top < y < o.bottom for o in obstacles):
            return Scene(**{**LAW, **law}, x0=x, y0=y, vx0=vx, vy0=vy, obstacles=obstacles)


def features(scene, monitors, body, events):
    """What a motion in an arena meets."""
    left, top, right, bottom = bounding_box(monitors)
    outer = {"floor": (bottom - body[1],), "ceiling": (top,), "wall": (left, right - body[0])}
    names = {"floor": "step", "wall": "step wall", "ceiling": "lintel", "edge": "edge"}
    found = set()

    def monitor(state):
        x, y = state.x + body[0] / 2, state.y + body[1] / 2
        return [m for m in monitors if m[0] < x < m[0] + m[2] and m[1] < y < m[1] + m[3]]

    for event in events:
        if event.kind in names and event.side not in outer.get(event.kind, ()):
            found.add(names[event.kind])
            if event.kind == "floor" and event.before.y > event.side:
                found.add("over the step")
        if event.before.mode != GROUND and monitor(event.before) != monitor(event.after):
            found.add("portal")
    return found


def arena_scenes(count=126):
    """(family, scene, times, samples) of arena.csv."""
    draw, seen = Draw("arena"), {}
    for index in range(count):
        times = sample_times((5 if index % 4 else 2) * SECOND)
        name = list(LAYOUTS)[index % len(LAYOUTS)]
        monitors, body = LAYOUTS[name], BODIES[index // len(LAYOUTS) % len(BODIES)]
        wanted = WANTED[index % len(WANTED)]
        for attempt in itertools.count():
            scene = in_arena(draw, monitors, body)
            samples, events, doubts = exact_model.solve(scene, times)
            found = features(scene, monitors, body, events)
            if not doubts and (not wanted or wanted in found or attempt >= 40):
                break
        for feature in found:
            seen[feature] = seen.get(feature, 0) + 1
        yield name, scene, times, samples
        if index % 18 == 17:
            progress(f"arena: {index + 1} {dict(sorted(seen.items()))}")


def progress(text):
    print(text, file=sys.stderr, flush=True)


def number(value):
    """The shortest text that reads back as this double."""
    text = repr(float(value))
    return text[:-2] if text.endswith(".0") else text


def result(value):
    """A computed number in 25 significant digits."""
    if abs(value) < NOTHING:
        return "0"
    text = mpmath.nstr(value, PRINTED_DIGITS)
    return text[:-2] if text.endswith(".0") else text


def outputs(samples):
    """The result columns of a scene's rows."""
    return [[*map(result, (s.x, s.y, s.vx, s.vy)), s.mode, str(events)] for s, events in samples]


def write(path, what, scenes):
    """Writes one file of references."""
    with open(path, "w", newline="", encoding="ascii") as file:
        file.write(f"# {what}; from make_references.py: mpmath, {exact_model.DIGITS} working digits, "
                   f"{PRINTED_DIGITS} printed; px, s, y down; obstacles left:top:right:bottom, ledges top:left:right\n")
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(COLUMNS)
        for index, (family, scene, times, samples) in enumerate(scenes):
            obstacles = ";".join(":".join(map(number, o)) for o in scene.obstacles + scene.ledges)
            for time, values in zip(times, outputs(samples)):
                rows.writerow([index, family, *(number(getattr(scene, name)) for name in INPUTS), obstacles,
                               time, *values])


def check(path, every):
    """Solves every n-th scene of a file again; the number of scenes that differ."""
    with open(path, newline="", encoding="ascii") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    scenes = [list(group) for _, group in itertools.groupby(rows, key=lambda row: row["scene"])]
    wrong = 0
    for group in scenes[::every]:
        solids = [tuple(map(float, o.split(":"))) for o in group[0]["obstacles"].split(";")]
        scene = Scene(**{name: float(group[0][name]) for name in INPUTS},
                      obstacles=tuple(Obstacle(*o) for o in solids if len(o) == 4),
                      ledges=tuple(Ledge(*o) for o in solids if len(o) == 3))
        samples, _, _ = exact_model.solve(scene, [int(row["t_ns"]) for row in group],
                                          digits=exact_model.DIGITS + 40)
        if outputs(samples) != [[row[name] for name in COLUMNS[-6:]] for row in group]:
            progress(f"{path}: scene {group[0]['scene']} ({group[0]['family']}) differs")
            wrong += 1
    progress(f"{path}: {len(scenes[::every])} of {len(scenes)} scenes solved again, {wrong} differ")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", nargs="+", metavar="FILE", help="compare these files instead of writing")
    parser.add_argument("--every", type=int, default=10, help="with --check: every n-th scene (default 10)")
    arguments = parser.parse_args()
    if arguments.check:
        sys.exit(1 if sum(check(path, arguments.every) for path in arguments.check) else 0)
    write(HERE / "box.csv", "Exact motions of a point in one box", box_scenes())
    write(HERE / "arena.csv", "Exact motions of a body's corner across several monitors", arena_scenes())


if __name__ == "__main__":
    main()
