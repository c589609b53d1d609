# SPDX-License-Identifier: MIT
"""The motion of a point among rectangles and one-way floors, solved to 50 digits with mpmath.

Units px, s, px/s; y points down. Between two events the point follows the exact flight; the time of
an impact is the root of "coordinate minus side", bracketed and then refined by Newton steps inside
the bracket. Decisions that stand on the edge (a corner met within 1e-7 px, a rebound within 1e-9 of
the threshold, ...) are listed, so that a caller can leave such scenes out.
"""

import collections
import dataclasses
import math

import mpmath
from mpmath import mpf

AIR, GROUND, REST = "AIR", "GROUND", "REST"
DIGITS = 70            # working digits for k = 0 or k >= 1; 50 of the results are right
VISIBLE_HOP = 0.01     # [px] hops lower than this end the bouncing
SAME = mpf(10) ** -45  # [s], [px] what differs by less is the same time or place
NEAR = 1e-7            # [px] a corner or a side this close leaves the decision open
NEAR_TIME = 1e-9       # [s] two events this close leave their order open
NEAR_SPEED = 1e-9      # relative distance of a speed to its threshold that leaves the decision open
LOOK_AHEAD = 1e-6      # [s] events this far behind the next one are looked at for a tie

Obstacle = collections.namedtuple("Obstacle", "left top right bottom")
Ledge = collections.namedtuple("Ledge", "top left right")  # stops what falls, and nothing else
Event = collections.namedtuple("Event", "time kind side before after")
Sample = collections.namedtuple("Sample", "state events")


@dataclasses.dataclass(frozen=True)
class Scene:
    """The input of one motion; every number is a double and means exactly its binary value."""
    k: float          # [1/s] air drag
    c: float          # [1/s] further drag on the ground
    G: float          # [px/s^2]
    beta: float
    mu: float
    eps: float        # [px/s] slowest rebound
    eps_x: float      # [px/s] stop speed
    x0: float
    y0: float
    vx0: float
    vy0: float
    obstacles: tuple  # of Obstacle, open rectangles
    ledges: tuple = ()  # of Ledge


@dataclasses.dataclass(frozen=True)
class State:
    """Place, velocity and mode at one moment."""
    x: mpf
    y: mpf
    vx: mpf
    vy: mpf
    mode: str


class TooManyEvents(Exception):
    """The scene exceeds the number of events the caller allows."""


def root(value, slope, low, high):
    """The zero between low and high of a function that rises from below 0 to above 0."""
    tolerance = mpf(10) ** (8 - mpmath.mp.dps) * (1 + high)
    if value(low) >= 0:
        return low
    at = low
    for _ in range(2000):
        error, steepness = value(at), slope(at)
        if error < 0:
            low = at
        else:
            high = at
        guess = at - error / steepness if steepness > 0 else low
        if not low < guess < high:
            guess = (low + high) / 2
        if abs(guess - at) <= tolerance or high - low <= tolerance:
            return guess
        at = guess
    raise ArithmeticError("no convergence")


def within(place, low, high, velocity):
    """Whether a side from low to high is met; at an end only when moving on to the side."""
    if abs(place - low) < SAME:
        return velocity > 0
    if abs(place - high) < SAME:
        return velocity < 0
    return low < place < high


class Motion:
    """One scene on its way: the flight from event to event."""

    def __init__(self, scene, event_limit):
        self.k, self.c, self.G = mpf(scene.k), mpf(scene.c), mpf(scene.G)
        self.beta, self.mu = mpf(scene.beta), mpf(scene.mu)
        self.eps = max(mpf(scene.eps), mpmath.sqrt(2 * self.G * mpf(VISIBLE_HOP)))
        self.eps_x = mpf(scene.eps_x)
        self.obstacles = [Obstacle(*map(mpf, sides)) for sides in scene.obstacles]
        self.floors = self.obstacles + [Ledge(*map(mpf, ends)) for ends in scene.ledges]
        self.event_limit = event_limit
        self.events = []
        self.fragile = []  # decisions too close to call, in words
        self.state = self.launched(mpf(scene.x0), mpf(scene.y0), mpf(scene.vx0), mpf(scene.vy0))

    def launched(self, x, y, vx, vy):
        """The state in which a motion begins."""
        on_floor = any(y == o.top and o.left < x < o.right for o in self.floors)
        if vy == 0 and self.G > 0 and on_floor:
            return self.grounded(State(x, y, vx, vy, GROUND))
        if self.G == 0 and (vx == vy == 0 or self.k > 0 and mpmath.hypot(vx, vy) <= self.eps_x):
            return State(x, y, mpf(0), mpf(0), REST)
        return State(x, y, vx, vy, AIR)

    def grounded(self, state):
        """A state on the ground, or at rest when too slow to slide."""
        self.doubt_speed("stop speed", abs(state.vx), self.eps_x)
        if abs(state.vx) <= self.eps_x:
            return State(state.x, state.y, mpf(0), mpf(0), REST)
        return dataclasses.replace(state, vy=mpf(0), mode=GROUND)

    def doubt(self, what, distance, limit):
        """Notes a decision that a small error would turn."""
        if abs(distance) < limit:
            self.fragile.append(what)

    def doubt_speed(self, what, speed, threshold):
        """Notes a comparison of a speed with a threshold that is too close."""
        if speed != 0:
            self.doubt(what, speed - threshold, NEAR_SPEED * threshold)

    def after(self, time):
        """The state `time` seconds on, if no event comes between."""
        state = self.state
        if state.mode == REST:
            return state
        rate = self.k if state.mode == AIR else self.k + self.c
        if rate == 0:
            decay, length, fall = mpf(1), time, time * time / 2
        else:
            decay = mpmath.exp(-rate * time)
            length = (1 - decay) / rate
            fall = (time - length) / rate
        x, vx = state.x + state.vx * length, state.vx * decay
        if state.mode == GROUND:
            return State(x, state.y, vx, state.vy, GROUND)
        y, vy = state.y + state.vy * length + self.G * fall, state.vy * decay + self.G * length
        return State(x, y, vx, vy, AIR)

    def x_reaches(self, side, horizon):
        """When x comes to a side that lies ahead; None if not before the horizon."""
        sign = 1 if self.state.vx > 0 else -1
        return self.reaches(lambda t: sign * (self.after(t).x - side),
                            lambda t: sign * self.after(t).vx, mpf(0), horizon)

    def reaches(self, value, slope, low, high):
        """The time of a crossing between low and high, or None."""
        end = value(high)
        self.doubt("side", end, NEAR)
        return root(value, slope, low, high) if end > 0 else None

    def doubt_corner(self, place, time, ends, still):
        """Notes a passage close to the end of a side. Exact places at the start do not count."""
        for end in ends:
            exact = place == end and (time == 0 or still)
            if not exact:
                self.doubt("corner", place - end, NEAR)

    def wall(self, horizon):
        """The next vertical side that stands in the way: (time, side), or None."""
        state = self.state
        if state.vx == 0:
            return None
        right = state.vx > 0
        sides = {o.left if right else o.right for o in self.obstacles}
        ahead = [s for s in sides if mpmath.isfinite(s) and (s >= state.x if right else s <= state.x)]
        for side in sorted(ahead, key=lambda s: abs(s - state.x)):
            time = self.x_reaches(side, horizon)
            if time is None:
                return None
            then = self.after(time)
            hit = False
            for o in self.obstacles:
                if (o.left if right else o.right) == side:
                    self.doubt_corner(then.y, time, (o.top, o.bottom), state.mode == GROUND)
                    hit = hit or within(then.y, o.top, o.bottom, then.vy)
            if hit:
                return time, side
        return None

    def level(self, sides, value, slope, low, high, falling):
        """The first of the horizontal sides, nearest first, that is met between low and high."""
        for side in sides:
            time = self.reaches(lambda t, side=side: value(t, side), slope, low, high)
            if time is None:
                return None
            then = self.after(time)
            hit = False
            for o in self.floors if falling else self.obstacles:
                if (o.top if falling else o.bottom) == side:
                    self.doubt_corner(then.x, time, (o.left, o.right), self.state.vx == 0)
                    hit = hit or within(then.x, o.left, o.right, then.vx)
            if hit:
                return time, side
        return None

    def apex(self):
        """The time at which a rising point turns; infinite without gravity."""
        vy = self.state.vy
        if vy >= 0:
            return mpf(0)
        if self.G == 0:
            return mpf("inf")
        if self.k == 0:
            return -vy / self.G
        return mpmath.log(1 - self.k * vy / self.G) / self.k

    def ceiling(self, horizon):
        """The next lower side of an obstacle that a rising point meets: (time, side), or None."""
        if self.state.mode != AIR or self.state.vy >= 0:
            return None
        sides = sorted({o.bottom for o in self.obstacles if o.bottom <= self.state.y}, reverse=True)
        return self.level([s for s in sides if mpmath.isfinite(s)],
                          lambda t, side: side - self.after(t).y, lambda t: -self.after(t).vy,
                          mpf(0), min(self.apex(), horizon), False)

    def floor(self, horizon):
        """The next upper side or ledge that a falling point meets: (time, side), or None."""
        if self.state.mode != AIR or self.state.vy == 0 and self.G == 0:
            return None
        turn = self.apex()
        if turn >= horizon:
            return None
        top = self.after(turn).y
        starting = self.state.vy == 0  # a side at this very height is left, not met
        sides = sorted({o.top for o in self.floors if o.top > top or o.top == top and not starting})
        return self.level([s for s in sides if mpmath.isfinite(s)],
                          lambda t, side: self.after(t).y - side, lambda t: self.after(t).vy,
                          turn, horizon, True)

    def edge(self, horizon):
        """When the floor under a sliding point ends: (time, side), or None."""
        state = self.state
        if state.mode != GROUND:
            return None
        low = high = state.x
        floors = [o for o in self.floors if o.top == state.y]
        for _ in floors:
            for o in floors:
                if o.left <= high and o.right >= low:
                    low, high = min(low, o.left), max(high, o.right)
        side = high if state.vx > 0 else low
        time = self.x_reaches(side, horizon) if mpmath.isfinite(side) else None
        return None if time is None else (time, side)

    def stop(self, horizon):
        """When a sliding point, or a floating one without gravity, has become too slow."""
        state = self.state
        if state.mode == GROUND:
            rate, speed = self.k + self.c, abs(state.vx)
        elif state.mode == AIR and self.G == 0:
            rate, speed = self.k, mpmath.hypot(state.vx, state.vy)
            self.doubt_speed("float speed", speed, self.eps_x)
        else:
            return None
        if rate == 0 or self.eps_x == 0 and speed > 0:
            return None
        time = mpmath.log(speed / self.eps_x) / rate if speed > self.eps_x else mpf(0)
        return (time, None) if time <= horizon else None

    def next_events(self, horizon):
        """The events of the earliest moment before the horizon: (time, {kind: side})."""
        found = {}
        finders = {"stop": self.stop, "floor": self.floor, "ceiling": self.ceiling,
                   "wall": self.wall, "edge": self.edge}
        for kind, finder in finders.items():
            event = finder(horizon)
            if event is not None:
                found[kind] = event
                horizon = min(horizon, event[0] + LOOK_AHEAD)
        if not found:
            return None
        times = sorted(time for time, _ in found.values())
        first = times[0]
        for time in times[1:]:  # a stop at 5 px/s needs longer for the same distance
            self.doubt("tie", time - first, NEAR_TIME * (100 if "stop" in found else 1))
        return first, {kind: side for kind, (time, side) in found.items() if time - first <= SAME}

    def struck(self, time, kinds):
        """The state after the events of one moment."""
        then = self.after(time)
        x, y, vx, vy, mode = then.x, then.y, then.vx, then.vy, then.mode
        if "wall" in kinds:
            kinds.pop("edge", None)
            x, vx = kinds["wall"], -self.beta * vx
            if self.cornered(x, y, vx):
                vx = mpf(0)
        if "edge" in kinds:
            x, mode = kinds["edge"], AIR
        if "ceiling" in kinds:
            y, vy = kinds["ceiling"], -self.beta * vy
        if "floor" in kinds:
            y, vx = kinds["floor"], self.mu * vx
            self.doubt_speed("rebound", self.beta * vy, self.eps)
            if self.beta * vy >= self.eps:
                vy = -self.beta * vy
            else:
                vy, mode = mpf(0), GROUND if self.G > 0 else AIR
        if "stop" in kinds:
            vx, vy, mode = mpf(0), mpf(0), REST
        state = State(x, y, vx, vy, mode)
        return self.grounded(state) if mode == GROUND and kinds.keys() & {"wall", "floor"} else state

    def cornered(self, x, y, vx):
        """Whether another wall stands right where the point has just turned."""
        facing = [o for o in self.obstacles if vx != 0 and (o.left if vx > 0 else o.right) == x]
        return any(o.top < y < o.bottom for o in facing)

    def check_free(self, state):
        """An obstacle is never entered."""
        for o in self.obstacles:
            if o.left < state.x < o.right and o.top < state.y < o.bottom:
                raise ArithmeticError(f"inside {o} at {state}")

    def run(self, times):
        """The samples at ascending times [s]."""
        samples, start = [], mpf(0)
        while True:
            step = self.next_events(times[-1] - start + LOOK_AHEAD)
            until = mpf("inf") if step is None else start + step[0]
            while len(samples) < len(times) and times[len(samples)] < until:
                elapsed = times[len(samples)] - start
                state = self.after(elapsed)
                self.check_free(state)
                self.check_free(self.after(elapsed / 64))
                samples.append(Sample(state, len(self.events)))
            for time in times:
                self.doubt("sample", time - until, NEAR_TIME)
            if len(samples) == len(times):
                return samples
            self.check_free(self.after(step[0] / 2))
            before, kinds = self.state, step[1]
            self.state = self.struck(step[0], kinds)
            self.check_free(self.state)
            start = until
            self.events += [Event(start, kind, side, before, self.state) for kind, side in kinds.items()]
            if len(self.events) > self.event_limit:
                raise TooManyEvents


def digits_for(k, digits=DIGITS):
    """Digits to work with: (t - (1 - e^-kt) / k) / k loses twice the leading zeros of k."""
    return digits + 2 * max(0, math.ceil(-math.log10(k))) if k > 0 else digits


def solve(scene, times_ns, event_limit=3000, digits=DIGITS):
    """(samples at the times [ns], events, decisions too close to call)."""
    with mpmath.workdps(digits_for(scene.k, digits)):
        motion = Motion(scene, event_limit)
        samples = motion.run([mpf(time) / 10 ** 9 for time in times_ns])
        return samples, motion.events, motion.fragile
