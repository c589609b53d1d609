# SPDX-License-Identifier: MIT
"""run, eval, repl and scripts of hyraxctl: script_test.py <hyrax-headless> <hyraxctl>"""
import json
import socket
import struct
import subprocess
import unittest

from served import Served, wait_for


class Scripts(Served):
    """What people do who write scripts."""

    def setUp(self):
        super().setUp()
        self.result("config", "set", "scripts.developer", "true")
        (self.profile / "scripts" / "a.lua").write_text("count = 3\n")
        self.result("reload")

    def script(self, name, text):
        path = self.runtime.parent / name
        path.write_text(text)
        return path

    def repl(self, text, *arguments):
        return subprocess.run(
            self.command("repl", *arguments), env=self.environment, input=text, capture_output=True, text=True, timeout=60
        )

    def test_eval_shows_values_and_errors(self):
        self.assertEqual(self.ctl("eval", "a.lua", "count + 1, 'x'").stdout, '4, "x"\n')
        self.assertEqual(self.ctl("eval", "a.lua", "print 'hello'").stdout, "hello\n")
        wrong = self.ctl("eval", "a.lua", "\nnope.x = 1")
        self.assertEqual((wrong.returncode, wrong.stdout), (1, ""))
        self.assertEqual(wrong.stderr, "hyraxctl: eval:2: attempt to index a nil value (global 'nope')\n")
        self.assertEqual(self.ctl("eval", "a.lua", "x" * 70000).returncode, 2)
        self.assertIn("known: a.lua", self.ctl("eval", "b.lua", "1").stderr)

    def test_code_that_never_ends_is_answered_and_costs_no_frame(self):
        self.result("config", "set", "physics.gravity", "0")
        self.result("fling", "0.1", "--vx", "40", "--vy", "-30")
        hung = self.ctl("eval", "a.lua", "while true do end")
        self.assertEqual(hung.returncode, 1)
        self.assertIn("used more than", hung.stderr)
        waiting = subprocess.Popen(
            self.command("eval", "a.lua", "hyrax.wait(100)"), env=self.environment, stderr=subprocess.PIPE, text=True
        )
        self.addCleanup(waiting.stderr.close)
        before = self.frames()
        wait_for(lambda: self.frames() > before + 5, 20, "frames")
        self.assertEqual(waiting.wait(30), 1)

    def test_a_client_that_leaves_before_its_answer_is_forgotten(self):
        self.assertIn("on", self.ctl("scripts").stdout)
        text = b'{"do": "eval", "script": "a.lua", "code": "hyrax.wait(1.5) count = 99"}'
        for _ in range(6):
            client = socket.socket(socket.AF_UNIX)
            client.connect(str(self.path))
            client.sendall(struct.pack("<I", len(text)) + text)
            client.close()
        self.assertEqual(self.ctl("eval", "a.lua", "count").stdout, "3\n")
        wait_for(lambda: self.ctl("eval", "a.lua", "count").stdout == "99\n", 20, "the code")

    def test_run(self):
        path = self.script("idea.lua", "runs = (runs or 0) + 1\n")
        self.assertEqual(self.ctl("run", path).stdout, "script  run:idea.lua\n")
        self.assertEqual(self.ctl("eval", "idea.lua", "runs").stdout, "1\n")
        self.assertEqual(self.result("run", path), {"script": "run:idea.lua"})
        refused = self.ctl("--json", "run", self.script("bad.lua", "nope.x = 1"))
        self.assertEqual((refused.returncode, json.loads(refused.stdout)["error"]["code"]), (1, "script_error"))
        big = self.script("big.lua", "text = [[" + "ä\n" * 100000 + "]]\n")
        self.assertEqual(self.ctl("run", big).returncode, 0)
        self.assertEqual(self.ctl("eval", "big.lua", "#text").stdout, "300000\n")
        bad = self.ctl("run", self.script("bad.lua", "\n\nerror('oh')\n"))
        self.assertEqual((bad.returncode, bad.stderr), (1, "hyraxctl: run:bad.lua:3: oh\n"))
        huge = self.ctl("run", self.script("huge.lua", "-" * ((1 << 20) + 1)))
        self.assertEqual(huge.returncode, 2)
        self.assertIn("huge.lua", huge.stderr)
        self.assertEqual(self.ctl("run", self.runtime / "none.lua").returncode, 2)
        self.assertEqual(self.ctl("run", "--stop", "idea.lua").returncode, 0)
        self.assertIn("run:big.lua", self.ctl("scripts").stdout)
        self.assertNotIn("idea", self.ctl("scripts").stdout)

    def test_repl(self):
        done = self.repl("a = 5\na + 1\nfunction f()\n\n  return 'many lines'\nend\nf()\n:quit\n1\n")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, '6\n"many lines"\n', ""))
        self.assertNotIn("repl", self.ctl("scripts").stdout)
        self.assertEqual(self.repl("count\n", "a.lua").stdout, "3\n")
        failing = self.repl("error('oh')\n2\nfor\n", "a.lua")
        self.assertEqual((failing.returncode, failing.stdout), (1, "2\n"))
        self.assertIn("eval:1: oh", failing.stderr)
        self.assertIn("near <eof>", failing.stderr)

    def test_nothing_of_it_without_the_setting(self):
        self.result("config", "set", "scripts.developer", "false")
        for arguments in (["eval", "a.lua", "1"], ["run", self.script("x.lua", "")], ["repl"]):
            refused = self.ctl(*arguments)
            self.assertEqual(refused.returncode, 1)
            self.assertIn("scripts.developer", refused.stderr)
        self.assertEqual(self.ctl("scripts", "off", "a.lua").returncode, 0)
        self.assertIn("off", self.ctl("scripts").stdout)
        self.assertEqual(self.ctl("scripts", "on", "a.lua").returncode, 0)
        self.assertEqual(self.ctl("scripts", "reload", "a.lua").returncode, 0)


unittest.main()
