#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes work_precision.csv: the scenes of `hyrax-bench work-precision`, solved to 50 digits.

One row is one sample of one scene: the input (shortest text of each double), the time, then place,
velocity and number of contacts up to that time. A scene that comes to rest has its last sample at
rest. Needs mpmath. Takes a few seconds.
"""

import argparse
import csv
import math
import pathlib
import sys

import mpmath

import exact_model
from exact_model import REST, Obstacle, Scene

HERE = pathlib.Path(__file__).resolve().parent
SECOND = 10 ** 9  # [ns]
PRINTED_DIGITS = 25
RATE = 60         # [1/s] frames at which the document's multipliers mean what they say
FRICTION, RESTITUTION, SLOWEST = 0.8, 0.6, 5.0
INF = math.inf
NOTHING = 1e-200  # printed as 0: not every reader takes numbers below the smallest double
COLUMNS = ("scene alpha k c G beta mu eps eps_x x0 y0 vx0 vy0 left top right bottom "
           "t x y vx vy contacts at_rest").split()


def scene(place, velocity, room, alpha=0.999, k=None, gravity=1200.0):
    """The document's constants, in a box of left, top, right, bottom for the top-left corner."""
    left, top, right, bottom = room
    walls = (Obstacle(-INF, -INF, left, INF), Obstacle(-INF, -INF, INF, top),
             Obstacle(right, -INF, INF, INF), Obstacle(-INF, bottom, INF, INF))
    k = -RATE * math.log(alpha) if k is None else k
    return alpha, room, Scene(k, -RATE * math.log(FRICTION), gravity, RESTITUTION, FRICTION, SLOWEST,
                              SLOWEST, *place, *velocity, walls)


FULL_HD = (0.0, 0.0, 1792.0, 952.0)
SCENES = {
    "flight": scene((1000.0, 1000.0), (600.0, -900.0), (0.0, 0.0, 100000.0, 100000.0)),
    "one bounce": scene((100.0, 0.0), (600.0, 0.0), (0.0, 0.0, 100000.0, 3750.0)),
    "document": scene((100.0, 0.0), (600.0, 0.0), FULL_HD),
    "fling": scene((100.0, 100.0), (8000.0, -6000.0), (0.0, 0.0, 672.0, 472.0)),
    "no drag": scene((100.0, 0.0), (600.0, 0.0), FULL_HD, alpha=1.0, k=0.0),
    "stiff drag": scene((100.0, 0.0), (14000.0, 0.0), FULL_HD, alpha=math.exp(-1e4 / RATE), k=1e4,
                        gravity=1e6),
}
TIMES = {"stiff drag": (1, 2, 5)}
USUAL_TIMES = (1, 2, 5, 10)
FLYING_TIMES = (1, 2, 5)


def text(number):
    """A number of mpmath's with enough digits for any double."""
    return mpmath.nstr(number, PRINTED_DIGITS, strip_zeros=True) if abs(number) > NOTHING else "0"


def rows(name):
    """The samples of one scene."""
    alpha, room, solved = SCENES[name]
    times = TIMES.get(name, FLYING_TIMES if name in ("flight", "one bounce") else USUAL_TIMES)
    samples, _, fragile = exact_model.solve(solved, [t * SECOND for t in times])
    if fragile:
        sys.exit(f"{name}: too close to call: {fragile}")
    inputs = [alpha, solved.k, solved.c, solved.G, solved.beta, solved.mu, solved.eps, solved.eps_x,
              solved.x0, solved.y0, solved.vx0, solved.vy0, *room]
    for time, (state, contacts) in zip(times, samples):
        yield [name, *map(repr, inputs), time, text(state.x), text(state.y), text(state.vx),
               text(state.vy), contacts, int(state.mode == REST)]


def main():
    """Writes the file."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", nargs="?", type=pathlib.Path, default=HERE / "work_precision.csv")
    path = parser.parse_args().file
    with path.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for name in SCENES:
            writer.writerows(rows(name))


if __name__ == "__main__":
    main()
