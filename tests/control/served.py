# SPDX-License-Identifier: MIT
"""A hyrax-headless that serves, and hyraxctl: for tests that get both programs as arguments."""
import json
import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import time
import unittest

HEADLESS, CTL = (pathlib.Path(argument) for argument in sys.argv[1:3])
del sys.argv[1:3]

CONFIG = """{
    // one pet, which falls
    "pets": {"start": [{"x": 300, "y": 100}], "max_spawn_rate": 10000}
}
"""


def wait_for(condition, seconds, what):
    end = time.monotonic() + seconds
    while not (value := condition()):
        if time.monotonic() > end:
            raise AssertionError(f"waited {seconds} s for {what}")
        time.sleep(0.02)
    return value


class Served(unittest.TestCase):
    """A daemon of its own, in a runtime folder of its own."""

    config = CONFIG
    options = ()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.runtime = pathlib.Path(folder.name) / "runtime"
        self.runtime.mkdir(mode=0o700)
        self.profile = pathlib.Path(folder.name) / "profile"
        (self.profile / "scripts").mkdir(parents=True)
        (self.profile / "config.json").write_text(self.config)
        self.environment = {**os.environ, "XDG_RUNTIME_DIR": str(self.runtime)}
        self.daemon = self.start()

    def start(self):
        daemon = subprocess.Popen(
            [HEADLESS, "--serve", "--config", self.profile / "config.json", *self.options],
            env=self.environment, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True,
        )  # fmt: skip
        self.addCleanup(self.end, daemon)
        wait_for(lambda: self.ctl("status").returncode == 0 or daemon.poll() is not None, 30, "the daemon")
        return daemon

    @staticmethod
    def end(daemon):
        if daemon.poll() is None:
            daemon.kill()
        daemon.wait()
        daemon.stderr.close()

    def command(self, *arguments):
        return [CTL, "--profile", self.profile, *map(str, arguments)]

    def ctl(self, *arguments):
        return subprocess.run(
            self.command(*arguments), env=self.environment, capture_output=True, text=True, timeout=60
        )

    def result(self, *arguments):
        done = self.ctl("--json", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        return json.loads(done.stdout)["result"]

    @property
    def path(self):
        (path,) = (self.runtime / "hyrax").glob("*.socket")
        return path

    def connect(self):
        client = socket.socket(socket.AF_UNIX)
        self.addCleanup(client.close)
        client.connect(str(self.path))
        client.settimeout(20)
        return client

    def frames(self):
        return self.result("status")["frames"]
