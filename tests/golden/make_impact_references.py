#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes impacts.csv beside this file: times of impact to 50 digits, by bisection. Needs mpmath.

function,a,b,c,d,time,sensitivity

fall: depth,velocity,gravity,drag    rise: height,speed,gravity,drag    glide: distance,speed,drag,-
Inputs are exact doubles in hexadecimal. The time is inf for never. The sensitivity is the relative
change of the time for one of the inputs, times the input: no double-precision solution can be trusted
to more than that many roundings. inf where a rounding decides whether there is an impact at all.
"""

import random
from pathlib import Path

from mpmath import exp, inf, mp, mpf, nstr

mp.dps = 60
STEP = mpf(2) ** -60  # relative, for the sensitivity


def decay(drag, t):
    """(1 - e^(-drag t)) / drag and (drag t - 1 + e^(-drag t)) / drag^2, by series where they cancel."""
    z = drag * t
    if z < mpf(10) ** -20:
        return t * (1 - z / 2 + z * z / 6), t * t * (mpf(1) / 2 - z / 6 + z * z / 24)
    one = 1 - exp(-z)
    return one / drag, (z - one) / drag / drag


def way(velocity, force, drag, t):
    first, second = decay(drag, t)
    return velocity * first + force * second


def speed(velocity, force, drag, t):
    return velocity * exp(-drag * t) + force * decay(drag, t)[0]


def rising_root(function, low, guess):
    """Where a function that is negative at low and then grows reaches zero."""
    high = guess
    for _ in range(4000):
        if function(high) >= 0:
            break
        low, high = high, 2 * high
    else:
        return inf
    while low == 0 and function(high / 2) >= 0:
        high /= 2
    low = max(low, high / 2)
    for _ in range(190):
        middle = (low + high) / 2
        low, high = (middle, high) if function(middle) < 0 else (low, middle)
    return high


def apex(velocity, gravity, drag):
    return rising_root(lambda t: speed(velocity, gravity, drag, t), mpf(0), -velocity / gravity)


def fall(depth, velocity, gravity, drag):
    if gravity == 0:
        return glide(depth, velocity, drag) if velocity > 0 <= depth else inf
    if depth == 0 and velocity >= 0:
        return mpf(0)
    if velocity >= 0:
        if depth < 0:
            return inf
        return rising_root(lambda t: way(velocity, gravity, drag, t) - depth, mpf(0), depth / max(velocity, 1))
    top = apex(velocity, gravity, drag)
    if way(velocity, gravity, drag, top) > depth:
        return inf
    return rising_root(lambda t: way(velocity, gravity, drag, t) - depth, top, 2 * top)


def rise(height, up, gravity, drag):
    if gravity == 0:
        return glide(height, up, drag)
    top = apex(-up, gravity, drag)
    if -way(-up, gravity, drag, top) <= height:
        return inf if height > 0 else mpf(0)
    if height == 0:
        return mpf(0)
    low = high = height / up
    while -way(-up, gravity, drag, high) < height:
        low, high = high, min(2 * high, top)
    for _ in range(190):
        middle = (low + high) / 2
        low, high = (middle, high) if -way(-up, gravity, drag, middle) < height else (low, middle)
    return high


def glide(distance, velocity, drag, _=None):
    if distance == 0:
        return mpf(0)
    if drag * distance >= velocity:
        return inf
    return rising_root(lambda t: way(velocity, 0, drag, t) - distance, mpf(0), distance / velocity)


FUNCTIONS = {"fall": fall, "rise": rise, "glide": glide}


def row(name, *inputs):
    inputs = [float(value) for value in inputs]
    exact = [mpf(value) for value in inputs]
    time = FUNCTIONS[name](*exact)
    total = mpf(0)
    for i, value in enumerate(exact):
        for sign in (1, -1):
            other = FUNCTIONS[name](*exact[:i], value * (1 + sign * STEP), *exact[i + 1:])
            if (other == inf) != (time == inf):
                total = inf
            elif time not in (0, inf):
                total += abs(other - time) / time / STEP / 2
    return [name, *(value.hex() for value in inputs), digits(time), nstr(total, 4)]


def digits(value):
    return "inf" if value == inf else nstr(value, 50, min_fixed=0, max_fixed=0)


def rows(rng):
    def scale(low, high):
        return low * (high / low) ** rng.random()

    for power in range(-64, 17):  # kap = drag speed / gravity
        velocity, gravity = scale(10, 1e4), scale(100, 1e4)
        yield row("fall", 0, -velocity, gravity, 10 ** (power / 4) * gravity / velocity)
    for power in range(-64, 17, 2):
        velocity, gravity, depth = scale(10, 1e4), scale(100, 1e4), scale(1, 4000)
        drag = 10 ** (power / 4) * gravity / velocity
        yield row("fall", depth, velocity, gravity, drag)
        yield row("fall", depth, -velocity, gravity, drag)
        yield row("rise", scale(1e-3, 0.9) * velocity**2 / 2 / gravity, velocity, gravity, drag)
    for _ in range(100):
        drag = rng.choice((0, 0.06003, 0.06003, 1, 20))
        yield row("fall", scale(1e-6, 4000), rng.uniform(-3000, 3000), 1200, drag)
    for _ in range(60):
        up = scale(50, 3000)
        drag = rng.choice((0, 0.06003, 1))
        yield row("fall", -rng.uniform(0, 1.1) * up**2 / 2400, -up, 1200, drag)
        yield row("rise", rng.uniform(0, 1.1) * up**2 / 2400, up, 1200, drag)
    for power in range(-14, -1):  # the apex that far from the line
        for sign in (1, -1):
            up = scale(50, 3000)
            height = up**2 / 2400 * (1 + sign * 10.0**power)
            yield row("rise", height, up, 1200, 0)
            yield row("fall", -height, -up, 1200, 0)
            top = apex(-mpf(up), mpf(1200), mpf(0.06))
            height = float(-way(-mpf(up), mpf(1200), mpf(0.06), top)) * (1 + sign * 10.0**power)
            yield row("rise", height, up, 1200, 0.06)
            yield row("fall", -height, -up, 1200, 0.06)
    for power in (2, 3, 5, 8, 12, 20, 30, 50, 100, 200, 300):
        yield row("fall", 952, 1000, 1200, 10.0**power)
        yield row("fall", 952, 0, 1e-3, 10.0**power)
        yield row("fall", 0, -1000, 1200, 10.0**power)
        yield row("fall", 1e-6, -1000, 1200, 10.0**power)
        yield row("rise", 10, 1000, 1200, 10.0**power)
        yield row("glide", 500, 1000, 10.0**power, 0)
        yield row("glide", 1e-3 * 10.0**-power, 1000, 10.0**power, 0)
    for power in (8, 100, 155, 200, 300):
        for drag in (0, 1e-3):
            yield row("fall", 952, 10.0**power, 1200, drag)
            yield row("rise", 952, 10.0**power, 1200, drag)
            yield row("glide", 952, 10.0**power, drag, 0)
        yield row("fall", 952, -(10.0**power), 1200, 0)
        yield row("fall", 952, -(10.0**power), 1200, 1e-3)
    for _ in range(40):
        yield row("glide", scale(1e-3, 4000), scale(10, 1e5), scale(1e-16, 10), 0)
        yield row("fall", scale(1, 4000), rng.uniform(-100, 3000), 0, rng.choice((0, 0.06)))


def main():
    with (Path(__file__).parent / "impacts.csv").open("w", encoding="utf-8", newline="\n") as file:
        for columns in rows(random.Random(2026)):
            file.write(",".join(columns) + "\n")


if __name__ == "__main__":
    main()
