# SPDX-License-Identifier: MIT
"""The scripts' process is killed, and then the daemon: script_kill_test.py <hyrax-headless> <hyraxctl>

HYRAX_KILL_ROUNDS=100 makes it long.
"""
import os
import pathlib
import random
import signal
import time
import unittest

from served import Served, wait_for

# Of a busy machine; usually a tenth of a second.
PATIENCE = 10


def status_of(pid):
    """(state, parent) of a process, None if there is none."""
    try:
        state, parent = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[:2]
    except OSError:
        return None
    return state, int(parent)


def children_of(parent):
    pids = (int(path.name) for path in pathlib.Path("/proc").iterdir() if path.name.isdigit())
    return [pid for pid in pids if (status := status_of(pid)) and status[1] == parent]


class Kills(Served):
    config = """{
    "pets": {"start": [{"count": 20, "vx": 90, "vy": -50}], "max_spawn_rate": 10000},
    "physics": {"gravity": 0, "air_drag": 1, "restitution": 1},
    "scripts": {"developer": true}
}"""
    options = ("--script-process",)

    def beats(self):
        """How often the script's timer has come since it was loaded; None while nobody answers."""
        done = self.ctl("eval", "a.lua", "beats")
        return int(done.stdout) if done.returncode == 0 else None

    def places(self):
        return {pet["id"]: (pet["x"], pet["y"]) for pet in self.result("list")["pets"]}

    def test_scripts_come_back_pets_stay_and_nothing_is_left(self):
        (self.profile / "scripts" / "a.lua").write_text(
            "beats = 0\nhyrax.every(0.02, function()\n  beats = beats + 1\n"
            "  for _, pet in ipairs(hyrax.pets{ all = true }) do\n"
            "    pet:fling(math.random(-200, 200), math.random(-200, 200))\n  end\nend)\n"
        )
        self.result("reload")
        chance = random.Random(7)
        pets = sorted(self.places())
        self.assertEqual(len(pets), 20)
        former = None
        for _ in range(int(os.environ.get("HYRAX_KILL_ROUNDS", "3"))):
            wait_for(lambda: (self.beats() or 0) > 3, PATIENCE, "scripts that run")
            (host,) = children_of(self.daemon.pid)
            self.assertNotEqual(host, former)
            before = self.places()
            time.sleep(chance.uniform(0, 0.1))
            os.kill(host, signal.SIGKILL)
            self.assertEqual(sorted(self.places()), pets)
            wait_for(lambda: self.places() != before, PATIENCE, "pets that move")
            # Neither it nor a zombie of it.
            wait_for(lambda: status_of(host) is None, PATIENCE, "the killed process to be gone")
            former = host
        wait_for(lambda: (self.beats() or 0) > 3, PATIENCE, "scripts that are back")
        self.assertEqual(sorted(self.places()), pets)
        (host,) = children_of(self.daemon.pid)
        self.daemon.kill()
        self.daemon.wait()
        # Whoever takes in orphans may be slow to bury them.
        gone = lambda: (status_of(host) or "Z")[0] == "Z"
        wait_for(gone, PATIENCE, "the scripts' process to follow its daemon")


unittest.main()
