# SPDX-License-Identifier: MIT
"""hyrax.exe on a virtual desktop, seen through its trace, its log and the screen."""

import csv
import io
import json
import re
import time

import desktop
from wine import windows_path

# The shipped sprite's box and, within it, a place that is fur in every pose.
BOX = (108, 92)
FUR = (50, 70)

# Nothing slows these down: they go from wall to wall for ever.
FLOATING = {"physics": {"gravity": 0, "air_drag": 1, "restitution": 1}}


def pets_at(*places, drowsy_after=60, **motion):
    """The part of a config that starts a pet at each place, all with the same velocity."""
    start = [{"x": x, "y": y, **motion} for x, y in places]
    return {"pets": {"start": start, "drowsy_after": drowsy_after}}


def grip(pet):
    """Where a hand gets hold of it."""
    return pet["x"] + FUR[0], pet["y"] + FUR[1]


def around(pet, margin=20):
    """(x, y, width, height) of its box with a margin at the sides and above; below are its feet."""
    return int(pet["x"]) - margin, int(pet["y"]) - margin, BOX[0] + 2 * margin, BOX[1] + margin


class Daemon:
    """Started with a profile of its own; `config` is config.json as a dict or as text."""

    def __init__(self, desk, exe, config, scripts=(), arguments=(), state=None, trace=True, env=None):
        self.desk, self.exe = desk, exe
        number = len(list(desk.folder.glob("profile-*")))
        self.profile = desk.folder / f"profile-{number}"
        (self.profile / "scripts").mkdir(parents=True)
        for name, text in dict(scripts).items():
            (self.profile / "scripts" / name).write_text(text)
        self.write_config(config)
        if state:
            (self.profile / "state.json").write_text(json.dumps(state))
        self.trace_file = desk.folder / f"trace-{number}.csv"
        self.statistics_file = desk.folder / f"statistics-{number}.jsonl"
        traced = ("--trace", windows_path(self.trace_file)) if trace else ()
        self.program = desk.start(
            exe, "--profile", windows_path(self.profile), *traced, "--stats", windows_path(self.statistics_file),
            "--for-testing", *arguments, env=env,
        )  # fmt: skip
        desktop.wait_for(lambda: self.log_text() or not self.program.running, 60, "the log")

    def write_config(self, config):
        text = config if isinstance(config, str) else json.dumps(config)
        (self.profile / "config.json").write_text(text)

    def second_start(self, *arguments):
        """Another start on the same profile; returns its exit code."""
        program = self.desk.start(self.exe, "--profile", windows_path(self.profile), *arguments)
        return program.wait(60)

    def log_text(self):
        try:
            return (self.profile / "hyrax.log").read_text(encoding="utf-8", errors="replace")
        except FileNotFoundError:
            return ""

    def wait_for_log(self, pattern, seconds=20):
        return desktop.wait_for(
            lambda: re.search(pattern, self.log_text(), re.MULTILINE),
            seconds,
            lambda: f"{pattern!r} in {self.log_text()}",
        )

    def state(self):
        """state.json, {} until there is one."""
        try:
            return json.loads((self.profile / "state.json").read_text())
        except FileNotFoundError:
            return {}

    def wait_for_state(self, key, value):
        desktop.wait_for(lambda: self.state().get(key) == value, 10, lambda: f"{key} to be {value} in {self.state()}")

    def statistics(self, post):
        """What the daemon has counted, asked for by post_message.exe."""

        def lines():
            return self.statistics_file.read_text().splitlines() if self.statistics_file.exists() else []

        known = len(lines())
        if code := self.desk.start(post, "hyrax.daemon", "hyrax.statistics").wait(60):
            raise AssertionError(f"post_message ended with {code}")
        desktop.wait_for(lambda: len(lines()) > known, 60, "statistics")
        return json.loads(lines()[-1])

    # --- the trace ----------------------------------------------------------------------------

    def rows(self):
        """All frames so far: dicts with numbers."""
        try:
            text = self.trace_file.read_text()
        except FileNotFoundError:
            return []
        complete = text[: text.rfind("\n") + 1]
        rows = list(csv.DictReader(io.StringIO(complete)))
        for row in rows:
            for key in ("time", "x", "y", "vx", "vy"):
                row[key] = float(row[key])
        return rows

    def pets(self):
        """The last frame: rows of the pets in it."""
        rows = self.rows()
        return [row for row in rows if row["time"] == rows[-1]["time"]]

    def wait_for_pets(self, condition, seconds=30, what="pets"):
        """The last frame's rows, once the condition holds for them."""

        def holds():
            ended = not self.program.running
            pets = self.pets()
            if condition(pets):
                return pets
            if ended:
                code = self.program.wait()
                raise AssertionError(f"ended with {code} before {what}: {self.program.text()}{self.log_text()}")
            return None

        def told():
            return f"{what}; {len(self.rows())} rows, the last ones: {self.pets()}; the log: {self.log_text()}"

        return desktop.wait_for(holds, seconds, told, step=0.1)

    def wait_for_grab(self):
        """Until a hand has held a pet."""
        self.wait_for_pets(lambda _: any(row["motion"] == "held" for row in self.rows()), 10, "the grab")

    def wait_for_rest(self, count=1):
        def resting(pets):
            return len(pets) == count and all(p["motion"] == "settled" and p["vx"] == 0 for p in pets)

        pets = self.wait_for_pets(resting, 40, f"{count} pets at rest")
        time.sleep(0.3)  # the picture follows the trace
        return pets

    def end(self):
        self.program.end()
