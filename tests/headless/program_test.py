# SPDX-License-Identifier: MIT
"""hyrax-headless as a user runs it: program_test.py <hyrax-headless>"""
import csv
import json
import os
import pathlib
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = pathlib.Path(sys.argv.pop())


def run(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                          timeout=60, **options)


class Program(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_shipped_config_gives_trace_and_snapshot(self):
        trace, picture = self.folder / "trace.csv", self.folder / "last.png"
        done = run("--seconds", 5, "--trace", trace, "--snapshot", picture, "--for-testing",
                   "--monitors", "800x600+0+0,640x480-640+50")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"3 pets \(0 moving, 3 asleep\) after 5 s: \d+ frames shown")
        self.assertRegex(done.stdout, r"event_driven: [\d.]+ contacts a second, energy [\d.e+]+ px\^2/s\^2, \d+ ns")
        rows = list(csv.DictReader(trace.read_text().splitlines()))
        self.assertGreater(len(rows), 200)
        self.assertTrue(all(-640 <= float(row["x"]) <= 800 for row in rows))
        self.assertEqual(rows[-1]["motion"], "settled")
        width, height = struct.unpack(">II", picture.read_bytes()[16:24])
        self.assertEqual((width, height), (1440, 600))

    def test_both_clocks_tell_the_same_figures(self):
        file = self.folder / "statistics.jsonl"
        for arguments in ([], ["--real-time"]):
            done = run("--seconds", 0.5, "--spawn", 2, "--for-testing", "--stats", file, *arguments)
            self.assertEqual(done.returncode, 0, done.stderr)
        virtual, real = (json.loads(line) for line in file.read_text().splitlines())
        self.assertEqual(virtual.keys(), real.keys())
        for told in (virtual, real):
            self.assertEqual(told["pets"], 5)
            self.assertGreater(told["frames"], 1)
            self.assertLess(told["frames"], 40)
            self.assertLessEqual(told["first_frame"], told["time"])
            self.assertGreater(told["resident_bytes"], told["private_bytes"])
        self.assertEqual(virtual["presented_bytes"], 0)
        self.assertGreaterEqual(real["presents"], real["frames"])
        self.assertGreater(real["presented_bytes"], 5 * 100 * 100 * 4)

    def test_statistics_when_asked(self):
        file = self.folder / "statistics.jsonl"
        program = subprocess.Popen([PROGRAM, "--real-time", "--seconds", "60", "--stats", file], stdout=subprocess.PIPE)
        lines = lambda: file.read_text().splitlines() if file.exists() else []
        end = time.monotonic() + 50
        while not lines() and time.monotonic() < end:
            time.sleep(0.2)  # before the program listens, the signal would end it
            if pathlib.Path(f"/proc/{program.pid}/status").read_text().count("SigBlk:\t0000000000000000") == 0:
                program.send_signal(signal.SIGUSR1)
        self.assertTrue(lines())
        program.terminate()
        out, _ = program.communicate(timeout=30)
        self.assertEqual(program.returncode, 0)
        self.assertIn(b"3 pets", out)
        self.assertGreaterEqual(len(lines()), 2)

    def test_same_input_same_trace(self):
        script = self.folder / "party.lua"
        # pairs walks in the order of hashes, which must not depend on the run.
        script.write_text("""
            local speeds = { slow = 100, quick = 700, left = -400, far = -900, high = 300 }
            hyrax.every(0.3, function()
                for _, vx in pairs(speeds) do hyrax.spawn{}:fling(vx + math.random(-90, 90), -600) end
            end)
        """)
        traces = []
        for name in ("a.csv", "b.csv"):
            done = run("--script", script, "--seconds", 3, "--trace", self.folder / name)
            self.assertEqual(done.returncode, 0, done.stderr)
            traces.append((self.folder / name).read_bytes())
        self.assertEqual(traces[0], traces[1])
        self.assertGreater(len(traces[0]), 10_000)

    @unittest.skipIf("HYRAX_SANITIZED" in os.environ, "a sanitizer does not fit into the cage")
    def test_same_input_same_trace_with_scripts_in_a_process_of_their_own(self):
        script = self.folder / "party.lua"
        script.write_text("""
            hyrax.every(0.3, function() hyrax.spawn{}:fling(math.random(-900, 900), -600) end)
            hyrax.on("land", function(pet) pet:fling(math.random(-300, 300), -400) end)
        """)
        bad = self.folder / "bad.lua"
        bad.write_text("local s = ('a'):rep(3000) s:find(('.-'):rep(10) .. 'b')")
        traces = []
        for name in ("a.csv", "b.csv"):
            done = run("--script-process", "--script", bad, "--script", script, "--seconds", 3,
                       "--trace", self.folder / name)  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("error: bad.lua: gave no sign of life", done.stderr)
            traces.append((self.folder / name).read_bytes())
        self.assertEqual(traces[0], traces[1])
        self.assertGreater(len(traces[0]), 10_000)

    def test_what_scripts_keep_at_the_end_is_written(self):
        script = self.folder / "last.lua"
        script.write_text("hyrax.on('unload', function(why) hyrax.store.set('why', why) end)")
        # A sanitizer does not fit into the cage.
        for process in ([],) if "HYRAX_SANITIZED" in os.environ else ([], ["--script-process"]):
            state = self.folder / f"state{len(process)}"
            done = run(*process, "--script", script, "--seconds", 1, "--state", state)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(json.loads((state / "store" / "last.lua.json").read_text()), {"why": "exit"})

    def test_options_that_would_do_nothing_are_refused(self):
        for clock, option in (
            ("--real-time", ["--windows", "w.csv"]),
            ("--serve", ["--windows", "w.csv"]),
            ("--real-time", ["--script-process"]),
        ):
            done = run(*option, clock, "--seconds", 1)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(f"{clock} excludes {option[0]}", done.stderr)

    def test_settings_that_surprise_are_explained(self):
        config = self.folder / "config.json"
        config.write_text('{"physics": {"gravity": 1e9}}')
        done = run("--config", config, "--seconds", 1)
        self.assertEqual(done.returncode, 0)
        self.assertIn("warning: config.json: /physics/gravity: 1e+09 px/s^2 is strong: a pet rests within", done.stderr)

    def test_script_errors_name_file_and_line(self):
        script = self.folder / "wrong.lua"
        script.write_text("local a = 1\nerror('oh no')\n")
        done = run("--script", script, "--seconds", 1)
        self.assertEqual(done.returncode, 0)
        self.assertIn("error: wrong.lua:2: oh no", done.stderr)

    def test_windows_come_from_a_file(self):
        config, windows, trace = self.folder / "config.json", self.folder / "windows.csv", self.folder / "t.csv"
        config.write_text('{"overlay": {"ledges": "all"}, "pets": {"start": [{"x": 500, "y": 100}]}}')
        windows.write_text("# one window\n0,7,400,600,500,300\n")
        done = run("--config", config, "--windows", windows, "--seconds", 8, "--trace", trace)
        self.assertEqual(done.returncode, 0, done.stderr)
        last = list(csv.DictReader(trace.read_text().splitlines()))[-1]
        self.assertEqual((float(last["x"]), last["motion"]), (500, "settled"))
        self.assertLess(float(last["y"]), 600)
        windows.write_text("0,7,400,600,500\n")
        wrong = run("--windows", windows)
        self.assertEqual(wrong.returncode, 1)
        self.assertIn("windows.csv:1: expected time,id,x,y,width,height", wrong.stderr)

    def test_cases_of_a_script_run_and_decide_the_exit_code(self):
        script = self.folder / "ball.lua"
        script.write_text("""
            local function drop() return hyrax.spawn{ x = 300, y = 0 } end
            if hyrax.test then
                local test = hyrax.test
                test.case("falls", function()
                    local pet = drop()
                    test.advance(60)
                    test.expect(pet.y > 500)
                    test.equal(#hyrax.pets{ all = true }, 1)
                end)
                test.case("speaks", function() drop():say("hi") end)
            end
        """)
        done = run("--test", script)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"\Aok 1 - falls # 60\.\d\d s\nok 2 - speaks # 0\.00 s\n1\.\.2\n\Z")
        script.write_text("hyrax.test.case('wrong', function()\n hyrax.test.equal(1, 2) end)")
        done = run("--test", script)
        self.assertEqual(done.returncode, 1)
        self.assertIn("not ok 1 - wrong", done.stdout)
        self.assertIn("# ball.lua:2: expected 2, got 1", done.stdout)
        script.write_text("hyrax.test.case('endless', function() hyrax.test.advance(100) end)")
        done = run("--test", script, "--seconds", 5)
        self.assertEqual(done.returncode, 1)
        self.assertIn("1 cases did not end in time", done.stdout)
        for text in ("", "error('main')", "hyrax.test.case('x', print) error('y')"):
            script.write_text(text)
            self.assertEqual(run("--test", script).returncode, 1, text)

    def test_what_a_script_keeps_needs_a_folder(self):
        script = self.folder / "keep.lua"
        script.write_text("local n = hyrax.store.get('n', 0) + 1 hyrax.store.set('n', n) print('start ' .. n)")
        for expected in (1, 1):
            self.assertIn(f"start {expected}", run("--script", script, "--seconds", 1).stderr)
        state = self.folder / "state"
        for expected in (1, 2, 3):
            done = run("--script", script, "--seconds", 1, "--state", state)
            self.assertIn(f"start {expected}", done.stderr)

    def test_a_snapshot_shows_what_pets_say(self):
        script = self.folder / "talk.lua"
        sizes = []
        for text in ("", "Hello, I am a hyrax and I talk a lot"):
            script.write_text(f"local p = hyrax.spawn{{ x = 300, y = 300 }} p:say('{text}', 60)")
            picture = self.folder / "talk.png"
            done = run("--script", script, "--seconds", 3, "--snapshot", picture, "--for-testing",
                       "--monitors", "800x600+0+0")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotIn("bubbles", done.stderr)
            sizes.append(picture.stat().st_size)
        self.assertGreater(sizes[1], sizes[0] + 500)

    def test_wrong_options_end_with_2(self):
        self.assertEqual(run("--nonsense").returncode, 2)
        self.assertEqual(run("--seconds", "-1").returncode, 2)
        self.assertEqual(run("--help").returncode, 0)
        broken = run("--monitors", "abc")
        self.assertEqual(broken.returncode, 1)
        self.assertIn("--monitors", broken.stderr)


unittest.main()
