#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes spring.csv beside this file: the held spring to 60 digits, from the complex roots. Needs mpmath.

matrix,zeta,w,t,a11,w*a12,a21/w,a22    the propagator; inputs are exact doubles in hexadecimal
track,zeta,w,x0,v0,c0,ticks            a body is grabbed; the rows below belong to it
sample,ticks,c                         a cursor sample
read,ticks,x,v                         where the body then is
"""

import itertools
import random
from pathlib import Path

from mpmath import exp, mp, mpf, nstr, sqrt

mp.dps = 100  # Near-equal roots of zeta = 1 +- 1e-16 cost 16 digits, and a decay of e^-100 some 40.
NS = 10**9
MIN_GLIDE, MAX_GLIDE = NS // 1000, NS // 60
PAUSE = NS // 20


def solution(zeta, w, t, e, rate):
    """(e, e') after t. From the roots p, q of s^2 + 2 zeta w s + w^2."""
    if w == 0:
        return e + rate * t, rate
    if zeta == 1:
        slope = rate + w * e
        decay = exp(-w * t)
        return decay * (e + slope * t), decay * (slope - w * (e + slope * t))
    root = w * sqrt(mpf(zeta) ** 2 - 1)
    p, q = -zeta * w + root, -zeta * w - root
    a = (rate - q * e) / (p - q)
    b = e - a
    at, bt = a * exp(p * t), b * exp(q * t)
    return (at + bt).real, (p * at + q * bt).real


def matrix_row(zeta, w, t):
    z, f, s = mpf(zeta), mpf(w), mpf(t)
    a11, a21 = solution(z, f, s, mpf(1), mpf(0))
    a12, a22 = solution(z, f, s, mpf(0), mpf(1))
    return ["matrix", *(float(v).hex() for v in (zeta, w, t)), *map(digits, (a11, f * a12, a21 / f, a22))]


def digits(value):
    return nstr(value, 25, min_fixed=0, max_fixed=0)


class Held:
    """One axis of a held body. Times are exact fractions of a second."""

    def __init__(self, zeta, w, x, v, c, ticks):
        self.zeta, self.w = mpf(zeta), mpf(w)
        self.x, self.v = mpf(x), mpf(v)
        self.line = (ticks, mpf(c), ticks, mpf(c))  # start, from, arrival, to
        self.time = self.sampled = ticks
        self.intervals = (0, 0)

    def advanced(self, ticks):
        """(x, v) at a moment that is not before self.time."""
        x, v = self.x, self.v
        start, source, arrival, goal = self.line
        for begin, end, slope in (
            (self.time, min(ticks, arrival), (goal - source) * NS / max(arrival - start, 1)),
            (max(self.time, arrival), ticks, mpf(0)),
        ):
            if end > begin:
                c = source + slope * mpf(begin - start) / NS if slope else goal
                t = mpf(end - begin) / NS
                e, rate = solution(self.zeta, self.w, t, x - c, v - slope)
                x, v = e + c + slope * t, rate + slope
        return x, v

    def follow(self, ticks, goal):
        self.x, self.v = self.advanced(ticks)
        start, source, arrival, old = self.line
        at = old if ticks >= arrival else source + (old - source) * mpf(ticks - start) / (arrival - start)
        if ticks - self.sampled <= PAUSE:
            self.intervals = (ticks - self.sampled, self.intervals[0])
        interval = min(max(*self.intervals, MIN_GLIDE), MAX_GLIDE)
        self.line = (ticks, at, max(arrival, ticks + interval), mpf(goal))
        self.time = self.sampled = ticks


def matrices(rng):
    powers = [10.0**-k for k in range(1, 17)]
    near = [1.0, *(1.0 + d for d in powers), *(1.0 - d for d in powers), 1.0 - 2.0**-53, 1.0 + 2.0**-52]
    for zeta, wt in itertools.product(near, (0.01, 0.7, 2.0, 6.0, 30.0)):
        yield matrix_row(zeta, 100.0, wt / 100.0)
    wide = [0.0, 1e-9, 0.01, 0.1, 0.5, 0.9, 1.5, 2.0, 10.0, 100.0, 1000.0]
    for zeta, wt in itertools.product(wide, (1e-6, 0.3, 1.7, 20.0, 300.0, 2000.0)):
        w = rng.choice((0.5, 10.0, 100.0, 1e3, 1e4))
        yield matrix_row(zeta, w, wt / w)
    for _ in range(200):
        w = 10.0 ** rng.uniform(-1.0, 5.0)
        yield matrix_row(10.0 ** rng.uniform(-3.0, 3.0), w, 10.0 ** rng.uniform(-4.0, 3.3) / w)


def track(rng, zeta, w, step, jitter):
    """A hand that wanders for 40 samples and then stands."""
    x, v, c = (float(rng.randrange(-2000, 2000)) for _ in range(3))
    time = rng.randrange(10**12)
    yield ["track", zeta.hex(), w.hex(), x.hex(), v.hex(), c.hex(), time]
    held = Held(zeta, w, x, v, c, time)
    speed = 0.0
    for _ in range(40):
        time += step + rng.randint(-jitter, jitter)
        speed += rng.uniform(-900.0, 900.0)
        c += round(speed * step / NS)
        yield ["sample", time, c.hex()]
        held.follow(time, c)
        for after in sorted((0, rng.randrange(step), step - jitter)):
            if rng.random() < 0.5:
                yield ["read", time + after, *map(digits, held.advanced(time + after))]
    for after in (10**7, 5 * 10**7, 10**9):
        yield ["read", time + after, *map(digits, held.advanced(time + after))]


def rows():
    rng = random.Random(2026)
    yield from matrices(rng)
    mice = ((8_000_000, 0), (8_000_000, 3_000_000), (1_000_000, 400_000), (125_000, 0), (40_000_000, 30_000_000))
    constants = ((1.0, 120.0), (0.0, 30.0), (0.5, 80.0), (1.0 + 2.0**-52, 60.0), (10.0, 100.0), (1.0, 1e4))
    for (zeta, w), (step, jitter) in itertools.product(constants, mice):
        yield from track(rng, zeta, w, step, jitter)


def main():
    out = Path(__file__).with_name("spring.csv")
    with out.open("w", encoding="ascii", newline="\n") as file:
        for row in rows():
            print(*row, sep=",", file=file)


if __name__ == "__main__":
    main()
