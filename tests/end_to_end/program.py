# SPDX-License-Identifier: MIT
"""A Windows program that runs: what it prints, how it ends, and what /proc tells of it."""

import dataclasses
import os
import re
import subprocess
import time
from pathlib import Path


def wait_for(condition, seconds=10.0, what="the condition", step=0.02):
    """The first true value of `condition()`; AssertionError when none comes in time. `what` is a text,
    or a function that tells it as it is then."""
    end = time.monotonic() + seconds
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > end:
            raise AssertionError(f"waited {seconds} s for {what() if callable(what) else what}")
        time.sleep(step)


@dataclasses.dataclass(frozen=True)
class Thread:
    """What /proc tells of a thread since it began."""

    id: int
    name: str
    cpu: float  # seconds, in steps of the kernel's tick (10 ms)
    wakeups: int  # voluntary context switches
    preemptions: int


def threads(pid):
    """Every thread of a process, as Thread."""
    found = []
    for folder in Path(f"/proc/{pid}/task").iterdir():
        try:
            stat = (folder / "stat").read_text()
            status = (folder / "status").read_text()
        except OSError:
            continue  # it ended meanwhile
        user, system = (int(n) for n in stat.rsplit(")", 1)[1].split()[11:13])
        numbers = dict(re.findall(r"^(\w*voluntary_ctxt_switches):\s+(\d+)", status, re.MULTILINE))
        found.append(
            Thread(
                id=int(folder.name),
                name=stat[stat.index("(") + 1 : stat.rindex(")")],
                cpu=(user + system) / os.sysconf("SC_CLK_TCK"),
                wakeups=int(numbers["voluntary_ctxt_switches"]),
                preemptions=int(numbers["nonvoluntary_ctxt_switches"]),
            )
        )
    return found


def footprint(pid):
    """Resident and anonymous bytes and open descriptors of a process."""
    status = Path(f"/proc/{pid}/status").read_text()
    resident, anonymous = (1024 * int(re.search(rf"^{key}:\s+(\d+)", status, re.M)[1]) for key in ("VmRSS", "RssAnon"))
    return {"resident": resident, "anonymous": anonymous, "descriptors": len(list(Path(f"/proc/{pid}/fd").iterdir()))}


class Program:
    """A program that was started on a desktop; its output goes to a file."""

    def __init__(self, process, output):
        self._process, self.output, self.pid = process, Path(output), process.pid

    @property
    def running(self):
        return self._process.poll() is None

    def text(self):
        """All that it has printed so far."""
        return self.output.read_text(encoding="utf-8", errors="replace").replace("\r\n", "\n")

    def wait(self, seconds=30.0):
        """The exit code; AssertionError when it does not end in time."""
        try:
            return self._process.wait(seconds)
        except subprocess.TimeoutExpired:
            raise AssertionError(f"process {self.pid} still runs after {seconds} s") from None

    def wait_for_text(self, pattern, seconds=10.0):
        """The match of a regular expression in the output."""

        def found():
            match = re.search(pattern, self.text(), re.MULTILINE)
            if not match and not self.running:
                raise AssertionError(f"ended without printing {pattern!r}; it printed: {self.text()}")
            return match

        return wait_for(found, seconds, lambda: f"{pattern!r} in the output; so far: {self.text()}")

    def threads(self):
        return threads(self.pid)

    def wakeups(self):
        """How often each thread has woken since it began, by its id."""
        return {thread.id: thread.wakeups for thread in self.threads()}

    def woken_since(self, before):
        """How often it has woken since wakeups() told `before`."""
        return sum(count - before.get(thread, 0) for thread, count in self.wakeups().items())

    def end(self):
        if self.running:
            self._process.kill()
        self._process.wait()
