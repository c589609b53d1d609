# SPDX-License-Identifier: MIT
"""hyraxctl against a hyrax-headless that serves: ctl_test.py <hyrax-headless> <hyraxctl>"""
import json
import os
import signal
import socket
import stat
import struct
import subprocess
import sys
import time
import unittest

from served import CONFIG, CTL, HEADLESS, Served, wait_for


class Verbs(Served):
    def test_pets(self):
        spawned = self.result("spawn", "hyrax", "--count", 2, "--x", 50, "--y", 60, "--vx", -30, "--tag", "party")
        self.assertEqual(len(spawned["pets"]), 2)
        one, two = spawned["pets"]
        self.assertEqual(self.result("list", "--tag", "party")["total"], 2)
        self.assertEqual(self.result("fling", one, "--vx", 300, "--vy", -700), {"pets": 1})
        self.assertGreater(self.result("list", one)["pets"][0]["vx"], 0)
        self.assertEqual(self.result("stop", one), {"pets": 1})
        self.assertEqual(self.result("reset", "--tag", "party"), {"pets": 2})
        self.assertEqual(self.result("fling")["pets"], 3)
        self.assertEqual(self.result("remove", two), {"pets": 1})
        gone = self.ctl("stop", two)
        self.assertEqual((gone.returncode, gone.stdout), (1, ""))
        self.assertEqual(gone.stderr, f'hyraxctl: there is no pet "{two}"\n')
        self.assertEqual(self.result("remove"), {"pets": 2})
        self.assertEqual(self.result("list"), {"total": 0, "pets": []})

    def test_status_pause_resume_reload_scripts(self):
        status = self.result("status")
        self.assertEqual((status["pets"], status["paused"], status["problem"]), (1, False, ""))
        self.assertEqual(status["integrator"], "event_driven")
        self.assertEqual(self.result("pause"), {"paused": True})
        before = self.result("status")
        time.sleep(0.3)
        after = self.result("status")
        self.assertTrue(after["paused"])
        self.assertEqual(after["seconds"], before["seconds"])
        self.assertEqual(self.result("resume"), {"paused": False})
        wait_for(lambda: self.result("status")["asleep"] == 1, 20, "the pet to sleep")
        self.assertEqual(self.result("scripts"), {"scripts": []})
        (self.profile / "scripts" / "a.lua").write_text("local x = 1")
        self.assertEqual(self.result("reload"), {})
        expected = {"name": "a.lua", "state": "on", "bytes": 11, "error": ""}
        (script,) = self.result("scripts")["scripts"]
        self.assertEqual(script, script | expected)
        (self.profile / "config.json").write_text("{")
        broken = self.ctl("reload")
        self.assertEqual(broken.returncode, 1)
        self.assertIn("config.json:1:2: ", broken.stderr)

    def test_config(self):
        gravity = self.result("config", "get", "physics.gravity")
        self.assertEqual((gravity["value"], gravity["low"]), (1200, 0))
        self.assertEqual(self.result("config", "set", "physics.gravity", "0"), {"key": "physics.gravity", "value": 0})
        self.assertEqual(self.result("config", "get", "/physics/gravity")["value"], 0)
        self.assertEqual(self.result("config", "set", "physics.integrator", "rk45")["value"], "rk45")
        self.assertEqual(self.result("status")["integrator"], "rk45")
        self.assertEqual(self.result("config", "set", "scripts.run", '["b.lua"]')["value"], ["b.lua"])
        text = (self.profile / "config.json").read_text()
        self.assertIn("    // one pet, which falls\n", text)
        self.assertIn('"x": 300, "y": 100', text)
        refused = self.ctl("config", "set", "physics.restitution", "2")
        self.assertEqual(refused.returncode, 1)
        self.assertIn("/physics/restitution: must be a number from 0 to 1, got 2", refused.stderr)
        self.assertEqual((self.profile / "config.json").read_text(), text)
        self.assertEqual(sorted(p.name for p in self.profile.iterdir()), ["config.json", "scripts"])

    def test_a_config_that_cannot_be_written_stays(self):
        blocker = self.profile / "config.json.new"
        blocker.mkdir()
        refused = self.ctl("config", "set", "physics.gravity", "5")
        self.assertEqual(refused.returncode, 1)
        self.assertIn("config.json: cannot be replaced: ", refused.stderr)
        # It tries more than once: who lets go of the file in time is not noticed.
        waiting = subprocess.Popen(self.command("config", "set", "physics.gravity", "5"), env=self.environment)
        time.sleep(0.3)
        blocker.rmdir()
        self.assertEqual(waiting.wait(20), 0)
        self.assertEqual(self.result("config", "get", "physics.gravity")["value"], 5)
        (self.profile / "config.json").write_text(CONFIG)
        self.assertEqual((self.profile / "config.json").read_text(), CONFIG)

    def test_events_stream_until_the_daemon_quits(self):
        listener = subprocess.Popen(
            self.command("--json", "events", "spawn", "land", "remove"),
            env=self.environment, stdout=subprocess.PIPE, text=True,
        )  # fmt: skip
        self.addCleanup(listener.stdout.close)
        self.addCleanup(listener.wait)
        self.addCleanup(listener.kill)
        first = json.loads(listener.stdout.readline())
        self.assertEqual(first["result"]["events"], ["spawn", "remove", "land"])
        (pet,) = self.result("spawn", "--x", 50, "--y", 300)["pets"]
        heard = [json.loads(listener.stdout.readline()) for _ in range(2)]
        mine = [event for event in heard if event["pet"] == pet]
        self.assertEqual(mine[0]["event"], "spawn")
        self.result("remove", pet)
        while (last := json.loads(listener.stdout.readline()))["event"] != "remove":
            pass
        self.assertEqual(last["pet"], pet)
        self.assertEqual(self.result("quit"), {})
        self.assertEqual(listener.wait(10), 0)
        self.assertEqual(self.daemon.wait(10), 0)
        self.assertEqual(self.ctl("status").returncode, 3)

    def test_people_read_tables(self):
        shown = self.ctl("list").stdout.splitlines()
        self.assertRegex(shown[0], r"^id +kind +state +x +y +vx +vy +owner +tag$")
        self.assertRegex(shown[1], r"^0\.1  hyrax  (airborne|at rest|sliding) +300 ")
        self.assertRegex(self.ctl("status").stdout, r"(?m)^integrator +event_driven$")
        self.assertRegex(self.ctl("config", "get").stdout, r"(?m)^physics\.gravity +1200 +px/s\^2$")
        self.assertEqual(self.ctl("pause").stdout, "paused  yes\n")


class Usage(Served):
    def test_wrong_usage_sends_nothing(self):
        for arguments, said in (
            (["spwan"], 'there is no "spwan"; did you mean "spawn"?'),
            (["spawn", "--count", "0"], "spawn: count: must be a whole number from 1 to 1000, got 0"),
            (["spawn", "--count", "many"], 'spawn: count: must be a whole number from 1 to 1000, got "many"'),
            (["spawn", "--cuont", "1"], "--cuont"),
            (["config", "set", "physics.gravty", "1"], 'did you mean "physics.gravity"?'),
            (["config", "set", "physics.gravity"], "value"),
            (["completion", "fish"], "bash or powershell"),
            ([], "subcommand"),
        ):
            with self.subTest(arguments=arguments):
                done = self.ctl(*arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertIn(said, done.stderr)

    def test_help_shows_an_example(self):
        self.assertIn("config", self.ctl("--help").stdout)
        self.assertIn("Example: hyraxctl spawn --count 3 --vy -600", self.ctl("spawn", "--help").stdout)
        self.assertRegex(self.ctl("--version").stdout, r"^hyraxctl \d")

    def test_no_daemon(self):
        nobody = self.runtime / "nobody"
        nobody.mkdir()
        done = subprocess.run(
            [CTL, "--profile", nobody, "status"], env=self.environment, capture_output=True, text=True, timeout=60
        )
        self.assertEqual(done.returncode, 3)
        self.assertIn(f"no hyrax runs with the profile {nobody}", done.stderr)
        without = {k: v for k, v in self.environment.items() if k != "XDG_RUNTIME_DIR"}
        done = subprocess.run([CTL, "status"], env=without, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 3)
        self.assertIn("XDG_RUNTIME_DIR", done.stderr)

    def complete(self, *words):
        """What bash offers for the last word."""
        script = (
            'eval "$("$1" completion bash)"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); '
            '_hyraxctl; printf "%s\\n" "${COMPREPLY[@]}"'
        )
        done = subprocess.run(["bash", "-c", script, "bash", CTL, *words], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.stderr, "")
        return done.stdout.split()

    def test_bash_completes(self):
        self.assertEqual(self.complete("hyraxctl", "sp"), ["spawn"])
        self.assertIn("config", self.complete("hyraxctl", ""))
        self.assertEqual(self.complete("hyraxctl", "--json", "config", "s"), ["set"])
        self.assertEqual(
            sorted(self.complete("hyraxctl", "config", "set", "physics.gr")),
            ["physics.gravity", "physics.grip_damping", "physics.grip_frequency", "physics.ground_friction"],
        )
        self.assertEqual(self.complete("hyraxctl", "--profile", "x", "events", "la"), ["land"])
        self.assertEqual(self.complete("hyraxctl", "spawn", "--co"), ["--count"])
        self.assertEqual(self.complete("hyraxctl", "scripts", "re"), ["reload"])
        self.assertEqual(self.complete("hyraxctl", "plugin", "in"), ["install"])
        self.assertEqual(self.complete("hyraxctl", "plugin", "install", "--re"), ["--replace"])
        self.assertEqual(self.complete("hyraxctl", "run", "--s"), ["--stop"])
        self.assertEqual(self.complete("hyraxctl", "run", "/etc/hostn"), ["/etc/hostname"])
        offered = subprocess.run(
            ["bash", "-c", f'eval "$("{CTL}" completion bash)"; complete -p hyraxctl'], capture_output=True, text=True
        )
        self.assertIn("_hyraxctl", offered.stdout)


class Socket(Served):
    def test_only_its_user_can_reach_it(self):
        self.assertEqual(stat.S_IMODE((self.runtime / "hyrax").stat().st_mode), 0o700)
        self.assertEqual(stat.S_IMODE(self.path.stat().st_mode), 0o600)

    @unittest.skipUnless(os.geteuid() == 0, "only root can become another user")
    def test_another_user_is_refused_even_where_the_files_would_let_him(self):
        self.runtime.parent.chmod(0o755)
        for place in (self.runtime, self.runtime / "hyrax"):
            place.chmod(0o755)
        self.path.chmod(0o666)
        code = (
            "import os, socket, sys; os.setuid(65534); s = socket.socket(socket.AF_UNIX); s.settimeout(20); "
            "s.connect(sys.argv[1]); s.sendall(b'\\x10\\0\\0\\0{\"do\": \"status\"}'); print(len(s.recv(100)))"
        )
        done = subprocess.run([sys.executable, "-c", code, self.path], capture_output=True, text=True, timeout=60)
        self.assertTrue(done.stdout == "0\n" or "Reset" in done.stderr or "Broken" in done.stderr, done)
        # And the client trusts no daemon of another user.
        fake = (
            "import os, socket, sys; s = socket.socket(socket.AF_UNIX); s.bind(sys.argv[1]); os.chmod(sys.argv[1], 0o666); "
            "os.setuid(65534); s.listen(); print('ready', flush=True); s.accept()[0].recv(1)"
        )
        path = self.path
        self.ctl("quit")
        self.daemon.wait(10)
        (self.runtime / "hyrax").chmod(0o700)
        squatter = subprocess.Popen([sys.executable, "-c", fake, path], stdout=subprocess.PIPE, text=True)
        self.addCleanup(squatter.stdout.close)
        self.addCleanup(squatter.wait)
        self.addCleanup(squatter.kill)
        squatter.stdout.readline()
        refused = self.ctl("status")
        self.assertEqual(refused.returncode, 3)
        self.assertIn("belongs to another user", refused.stderr)

    def test_one_daemon_for_each_profile_and_crashes_leave_no_trace(self):
        second = subprocess.run(
            [HEADLESS, "--serve", "--config", self.profile / "config.json"],
            env=self.environment, capture_output=True, text=True, timeout=60,
        )  # fmt: skip
        self.assertEqual(second.returncode, 1)
        self.assertIn("a hyrax with this profile serves already", second.stderr)
        self.daemon.kill()
        self.daemon.wait()
        self.assertTrue(self.path.exists())
        self.assertEqual(self.ctl("status").returncode, 3)
        self.daemon = self.start()
        self.assertEqual(self.result("status")["pets"], 1)
        self.daemon.send_signal(signal.SIGTERM)
        self.assertEqual(self.daemon.wait(10), 0)
        self.assertEqual(list((self.runtime / "hyrax").glob("*.socket")), [])

    def test_a_folder_that_others_may_enter_is_refused(self):
        self.ctl("quit")
        self.daemon.wait(10)
        (self.runtime / "hyrax").chmod(0o755)
        refused = subprocess.run(
            [HEADLESS, "--serve", "--config", self.profile / "config.json"],
            env=self.environment, capture_output=True, text=True, timeout=60,
        )  # fmt: skip
        self.assertEqual(refused.returncode, 1)
        self.assertIn("mode 0700", refused.stderr)

    def test_broken_clients_are_answered_or_dropped_and_cost_no_frame(self):
        self.result("config", "set", "physics.gravity", "0")  # it floats for ever: every frame is drawn
        self.result("fling", "0.1", "--vx", "40", "--vy", "-30")
        quiet = self.frame_rate(lambda: time.sleep(1.0))
        busy = self.frame_rate(self.send_nonsense)
        # A daemon that waited for one of them would draw nothing for two seconds.
        self.assertGreater(busy, 0.5 * quiet)

    def frame_rate(self, act):
        """Frames that the daemon draws in a second, while this is done."""
        first, begin = self.frames(), time.monotonic()
        act()
        return (self.frames() - first) / (time.monotonic() - begin)

    def send_nonsense(self):
        slow = self.connect()
        slow.sendall(b"\x40\0\0\0{")
        huge = self.connect()
        huge.sendall(struct.pack("<I", 65537) + b"x" * 5000)
        try:
            self.assertEqual(huge.recv(1), b"")
        except ConnectionResetError:
            pass
        for garbage in (b"", b"\x02", b"\x02\0\0", b"\0\0\0\0", b"\xff" * 100):
            client = self.connect()
            client.sendall(garbage)
            client.close()
        unfinished = self.connect()
        unfinished.sendall(b"\x02\0\0")
        wrong = self.connect()
        wrong.sendall(struct.pack("<I", 9) + b"[1, \"\xff\xfe\"]"[:9])
        length = struct.unpack("<I", wrong.recv(4, socket.MSG_WAITALL))[0]
        self.assertEqual(json.loads(wrong.recv(length, socket.MSG_WAITALL))["error"]["code"], "bad_json")
        self.assertEqual(wrong.recv(1), b"")
        # One byte at a time, and never done: it is not waited for.
        with self.assertRaises((BrokenPipeError, ConnectionResetError)):
            for _ in range(60):  # bytes, of which the request needs 63 more
                slow.sendall(b" ")
                time.sleep(0.1)

    def test_a_listener_that_does_not_read_is_dropped(self):
        deaf = self.connect()
        deaf.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        request = b'{"do": "events"}'
        deaf.sendall(struct.pack("<I", len(request)) + request)
        busy = self.connect()
        busy.sendall(struct.pack("<I", len(request)) + request)
        busy.recv(1)
        self.assertIn("hear of events already", self.ctl("events").stderr)
        for _ in range(70):
            self.result("spawn", "--count", 90)
            self.result("remove")
        # Its place is free again.
        listener = subprocess.Popen(self.command("events"), env=self.environment, stdout=subprocess.PIPE, text=True)
        self.addCleanup(listener.stdout.close)
        self.addCleanup(listener.wait)
        self.addCleanup(listener.kill)
        time.sleep(0.3)
        self.result("spawn")
        self.assertRegex(listener.stdout.readline(), r"^ +\d+\.\d{3}  spawn +pet=\d+\.\d+  kind=hyrax$")

    def test_a_fifth_client_waits_for_its_turn(self):
        idle = [self.connect() for _ in range(4)]
        self.assertEqual(self.ctl("status").returncode, 0)
        for client in idle:
            self.assertEqual(client.recv(1), b"")

    def test_nothing_is_drawn_for_a_client_that_waits(self):
        wait_for(lambda: self.result("status")["asleep"] == 1, 20, "the pet to sleep")
        self.result("pause")
        self.connect()
        before = self.frames()
        time.sleep(1.0)
        self.assertLessEqual(self.frames() - before, 3)


unittest.main()
