#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes ledges.csv: motions of a body's upper left corner among one-way floors, solved to 50 digits.

The rows are those of make_references.py, whose `--check` also takes this file; a ledge stands among
the obstacles as top:left:right. Needs mpmath. Takes half a minute on one core.
"""

import dataclasses
import itertools

import exact_model
from exact_model import Ledge
from make_references import (
    BODIES, HERE, LAYOUTS, SECOND, Draw, bounding_box, in_arena, progress, sample_times, write,
)

LEDGE_WANTED = ["ledge", "rest on it", "off its end", "from below", "two of them"]


def with_ledges(draw, monitors, body):
    """A scene among some ledges, which now and then starts on one of them."""
    scene, (left, top, right, bottom) = in_arena(draw, monitors, body), bounding_box(monitors)
    tops = []
    for _ in range(1 + int(draw.random.random() * 8)):
        y, low = int(draw.between(top + 40, bottom)), int(draw.between(left - 200, right - 100))
        tops.append(Ledge(y - body[1], low - body[0], low + int(draw.between(80, 900))))
    scene = dataclasses.replace(scene, ledges=tuple(tops))
    if draw.random.random() < 0.3:
        ledge = draw.pick(tops)
        scene = dataclasses.replace(scene, x0=draw.place(ledge.left, ledge.right), y0=float(ledge.top),
                                    vy0=draw.pick((0.0, 0.0, scene.vy0)))
    free = not any(o.left <= scene.x0 <= o.right and o.top < scene.y0 < o.bottom for o in scene.obstacles)
    return scene if free else with_ledges(draw, monitors, body)


def ledge_features(scene, events, end):
    """What a motion has to do with the ledges."""
    found, tops = set(), {ledge.top for ledge in scene.ledges}
    met = [e for e in events if e.kind == "floor" and e.side in tops]
    if met:
        found.add("ledge")
    if len({e.side for e in met}) > 1:
        found.add("two of them")
    if end.mode == exact_model.REST and end.y in tops:
        found.add("rest on it")
    if any(e.kind == "edge" and e.before.y in tops for e in events):
        found.add("off its end")
    if any(e.before.y > e.side for e in met):
        found.add("from below")
    return found


def ledge_scenes(count=45):
    """(family, scene, times, samples) of ledges.csv."""
    draw, seen = Draw("ledges"), {}
    for index in range(count):
        times = sample_times((5 if index % 4 else 2) * SECOND)
        name = "one" if index % 2 else list(LAYOUTS)[index % len(LAYOUTS)]
        monitors, body = LAYOUTS.get(name, [(0, 0, 1920, 1040)]), BODIES[index % len(BODIES)]
        wanted = LEDGE_WANTED[index % len(LEDGE_WANTED)]
        for attempt in itertools.count():
            scene = with_ledges(draw, monitors, body)
            samples, events, doubts = exact_model.solve(scene, times)
            found = ledge_features(scene, events, samples[-1].state)
            if not doubts and (wanted in found or attempt >= 60):
                break
        for feature in found:
            seen[feature] = seen.get(feature, 0) + 1
        yield name, scene, times, samples
    progress(f"ledges: {count} {dict(sorted(seen.items()))}")


if __name__ == "__main__":
    write(HERE / "ledges.csv", "Exact motions of a body's corner among one-way floors", ledge_scenes())
