# SPDX-License-Identifier: MIT
"""Scenes of many pets, and what the machine tells of the processes that show them."""

import json
import os
import random
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "end_to_end"))

import desktop  # noqa: E402
import wine  # noqa: E402

SCREEN = (1920, 1080)
BOX = (108, 92)  # of the shipped sprite
THROW = """
hyrax.every(3, function()
    for _, pet in ipairs(hyrax.pets{ all = true }) do
        pet:fling(math.random(-600, 600), math.random(-900, -300))
    end
end)
"""


def config(pets, state, fps):
    """Elastic pets that fly for ever, spread over the screen (state "flying") or slide to and fro along
    its lower edge without friction ("floor"); or pets that lie there ("rest"), or are thrown from there every three
    seconds, with the shipped physics ("thrown"). In state "hurried" they fly as far in a frame as they would at 60 Hz."""
    moving = state not in ("rest", "thrown")
    haste = fps / 60 if state == "hurried" else 1
    chance = random.Random(pets)
    start = []
    for _ in range(pets):
        pet = {"x": chance.randint(0, SCREEN[0] - BOX[0]), "y": SCREEN[1] - BOX[1]}
        if moving:
            pet["vx"] = haste * chance.choice((-1, 1)) * chance.randint(40, 400)
        if state in ("flying", "hurried"):
            pet["y"] = chance.randint(0, SCREEN[1] - BOX[1])
            pet["vy"] = haste * chance.randint(-400, 400)
        start.append(pet)
    physics = {"restitution": 1, "air_drag": 1, "ground_friction": 1, "rest_threshold": 0} if moving else {}
    return {
        "physics": physics,
        "pets": {"start": start, "max": 1000, "drowsy_after": 8 if moving else 0},
        "overlay": {"fps": fps},
        "scripts": {"run": ["throw.lua"] if state == "thrown" else []},
    }


def furnish(folder, settings):
    """A profile with these settings, and the script that they may name."""
    (folder / "scripts").mkdir(parents=True)
    (folder / "scripts" / "throw.lua").write_text(THROW)
    (folder / "config.json").write_text(json.dumps(settings))


def cpu_and_wakeups(pids):
    """Seconds of processor time and voluntary context switches of all threads so far."""
    cpu = wakeups = 0
    for task in [task for pid in pids for task in Path(f"/proc/{pid}/task").iterdir()]:
        try:
            cpu += int((task / "schedstat").read_text().split()[0]) / 1e9
            wakeups += int(re.search(r"^voluntary_ctxt_switches:\s+(\d+)", (task / "status").read_text(), re.M)[1])
        except OSError:
            pass  # it ended meanwhile
    return cpu, wakeups


def memory(pid):
    """Resident, anonymous and proportional [bytes]."""
    text = Path(f"/proc/{pid}/status").read_text() + Path(f"/proc/{pid}/smaps_rollup").read_text()
    return tuple(1024 * int(re.search(rf"^{key}:\s+(\d+)", text, re.M)[1]) for key in ("VmRSS", "RssAnon", "Pss"))


class Headless:
    """hyrax-headless on the real clock."""

    def __init__(self, program, folder, settings):
        furnish(folder, settings)
        self.statistics = folder / "statistics.jsonl"
        self.begin = time.time()
        log = open(folder / "hyrax.log", "wb")
        self._process = subprocess.Popen(
            [program, "--real-time", "--seconds", "3600", "--for-testing", "--monitors", "%dx%d+0+0" % SCREEN,
             "--config", folder / "config.json", "--stats", self.statistics],
            stdout=log, stderr=log,
        )  # fmt: skip
        log.close()
        self.pid, self.hosts, self.others = self._process.pid, [], {}
        # Before it listens, the signal would end it.
        blocked = lambda: int(re.search(r"^SigBlk:\s+(\w+)", Path(f"/proc/{self.pid}/status").read_text(), re.M)[1], 16)
        desktop.wait_for(lambda: blocked() >> (signal.SIGUSR1 - 1) & 1, 30, "hyrax-headless", step=0.002)

    def tell(self):
        return _next_line(self.statistics, lambda: os.kill(self.pid, signal.SIGUSR1))

    def end(self):
        self._process.terminate()
        self._process.wait(30)


class OnWine:
    """hyrax.exe on a virtual desktop; `hosts` are its processes for scripts, `others` those that serve it."""

    def __init__(self, desk, exe, post, folder, settings):
        furnish(folder, settings)
        self._desk, self._exe, self._post, self._folder = desk, exe, post, folder
        # Beside the profile, whose changes would wake the daemon.
        self.statistics = folder.with_suffix(".jsonl")
        self.begin = time.time()
        self._program = desk.start(
            exe, "--profile", wine.windows_path(folder), "--for-testing", "--stats",
            wine.windows_path(self.statistics),
        )  # fmt: skip
        self.pid = self._program.pid

    @property
    def hosts(self):
        return [pid for pid, line in self._desk.processes() if "hyrax.exe" in line.split()[0] and pid != self.pid]

    @property
    def others(self):
        servers = [pid for pid, line in self._desk.processes() if "wineserver" in line.split()[0]]
        return {"wineserver": servers[0], "X": self._desk.server_pid}

    def tell(self):
        def ask():
            desktop.wait_for(
                lambda: self._desk.start(self._post, "hyrax.daemon", "hyrax.statistics").wait(60) == 0, 60, "the daemon"
            )

        return _next_line(self.statistics, ask)

    def end(self):
        if self._program.running:
            self._desk.start(self._exe, "--profile", wine.windows_path(self._folder), "--quit").wait(60)
        code = self._program.wait(60)
        if code:
            raise RuntimeError(f"hyrax.exe ended with {code}: {self._program.text()}")


def _next_line(file, ask):
    """The line that is added to the file once it was asked for."""
    lines = lambda: file.read_text().splitlines() if file.exists() else []
    known = len(lines())
    ask()
    desktop.wait_for(lambda: len(lines()) > known, 60, f"a line in {file}")
    return json.loads(lines()[-1])


def measure(shown, settle, seconds):
    """Waits, then measures for so long: figures of a second, and memory at the end."""
    time.sleep(settle)
    first = shown.tell()
    time.sleep(0.5)  # what asked has ended by then
    pids = {"process": [shown.pid, *shown.hosts]} | {name: [pid] for name, pid in shown.others.items()}
    before = {name: cpu_and_wakeups(of) for name, of in pids.items()}
    begin = time.monotonic()
    time.sleep(seconds)
    after = {name: cpu_and_wakeups(of) for name, of in pids.items()}
    passed = time.monotonic() - begin
    last = shown.tell()
    resident, anonymous, proportional = memory(shown.pid)
    span = last["time"] - first["time"]
    row = {f"{name}_core": (after[name][0] - before[name][0]) / passed for name in pids}
    row["switches"] = (after["process"][1] - before["process"][1]) / passed
    for key in ("frames", "presents", "presented_bytes", "resizes", "wakeups", "timer_wakeups"):
        row[key] = (last[key] - first[key]) / span
    row |= {key: last[key] for key in ("moving", "private_bytes", "handles", "gdi_objects", "user_objects", "failures")}
    row |= {"resident": resident, "anonymous": anonymous, "proportional": proportional}
    row["first_frame"] = last["first_frame"] - shown.begin
    return row
