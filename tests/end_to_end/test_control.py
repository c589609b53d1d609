# SPDX-License-Identifier: MIT
"""hyraxctl.exe against hyrax.exe under Wine, through the real pipe.

Usage: test_control.py hyrax.exe hyraxctl.exe
"""

import json
import stat
import tempfile
import time
import zipfile
from pathlib import Path

import fixture
from console import Console
from daemon import FLOATING, pets_at
from wine import windows_path


class Control(fixture.OnDesktop):
    def setUp(self):
        super().setUp()
        self.hyrax = self.daemon({**FLOATING, **pets_at((300, 300), vx=60, vy=20)})

    def start(self, *arguments):
        return self.program("ctl", "--profile", windows_path(self.hyrax.profile), "--json", *arguments)

    def ctl(self, *arguments, code=0):
        return self.text_of(self.start(*arguments), code)

    def result(self, *arguments):
        return json.loads(self.ctl(*arguments))["result"]

    def error(self, *arguments):
        return json.loads(self.ctl(*arguments, code=1))["error"]["code"]

    def test_every_verb(self):
        (pet,) = self.result("spawn", "--x", 50, "--y", 60, "--tag", "party")["pets"]
        self.assertEqual(self.result("list", "--tag", "party")["pets"][0]["id"], pet)
        self.assertEqual(self.result("fling", pet, "--vx", 300, "--vy", -70), {"pets": 1})
        self.assertGreater(self.result("list", pet)["pets"][0]["x"], 50)
        self.assertEqual(self.result("stop", pet), {"pets": 1})
        self.assertEqual(self.result("reset", pet), {"pets": 1})
        self.assertEqual(self.result("list", pet)["pets"][0]["x"], 50)
        self.assertEqual(self.result("remove", pet), {"pets": 1})
        self.assertEqual(self.error("stop", pet), "no_such_pet")
        self.assertEqual(self.result("pause"), {"paused": True})
        self.assertTrue(self.result("status")["paused"])
        self.assertEqual(self.result("resume"), {"paused": False})
        self.assertEqual(self.result("scripts"), {"scripts": []})
        self.assertEqual(self.result("config", "get", "physics.gravity")["value"], 0)
        self.assertEqual(self.result("config", "set", "physics.gravity", "5"), {"key": "physics.gravity", "value": 5})
        self.assertEqual(json.loads((self.hyrax.profile / "config.json").read_text())["physics"]["gravity"], 5)
        self.assertEqual(self.result("config", "get", "physics.gravity")["value"], 5)
        self.assertEqual(self.error("config", "set", "physics.restitution", "2"), "bad_value")
        self.assertEqual(self.result("reload"), {})
        self.assertIn("did you mean", self.ctl("spwan", code=2))
        listener = self.start("events", "spawn")
        listener.wait_for_text('"ok":true', 30)
        self.result("spawn")
        listener.wait_for_text('"event":"spawn"', 30)
        self.assertEqual(self.result("quit"), {})
        self.assertEqual(self.hyrax.program.wait(20), 0)
        self.assertEqual(listener.wait(20), 0)
        self.assertIn("no hyrax runs with the profile", self.ctl("status", code=3))

    def test_code_runs_in_scripts_only_for_developers(self):
        (self.hyrax.profile / "scripts" / "a.lua").write_text("count = 3\n")
        idea = self.hyrax.profile / "idea.lua"
        idea.write_text("pet = hyrax.spawn{ tag = 'mine' }\nprint(pet.tag)\n")
        self.result("reload")
        refused = ["eval", "a.lua", "count"], ["run", windows_path(idea)], ["repl"]
        for arguments in refused:
            self.assertIn("scripts.developer", self.ctl(*arguments, code=1))
        self.assertEqual(self.result("list", "--tag", "mine")["total"], 0)
        self.result("config", "set", "scripts.developer", "true")
        self.assertEqual(self.result("eval", "a.lua", "count + 1, 'x'")["value"], '4, "x"')
        self.assertEqual(self.result("eval", "a.lua", "print 'hello'")["printed"], "hello\n")
        self.assertEqual(self.error("eval", "a.lua", "nope.x = 1"), "script_error")
        self.assertIn("used more than", self.ctl("eval", "a.lua", "while true do end", code=1))
        self.assertEqual(self.result("run", windows_path(idea)), {"script": "run:idea.lua"})
        self.assertEqual(self.result("list", "--tag", "mine")["total"], 1)
        self.assertEqual(self.result("eval", "idea.lua", "pet.tag")["value"], '"mine"')
        idea.write_text("\n\nerror('oh')\n")
        self.assertIn("run:idea.lua:3: oh", self.ctl("run", windows_path(idea), code=1))
        self.result("run", "--stop", "idea.lua")
        self.assertEqual([script["name"] for script in self.result("scripts")["scripts"]], ["a.lua"])
        self.result("config", "set", "scripts.developer", "false")
        for arguments in refused:
            self.assertIn("scripts.developer", self.ctl(*arguments, code=1))

    def test_lua_line_by_line_in_a_console(self):
        self.result("config", "set", "scripts.developer", "true")
        console = Console(self.desk, fixture.programs["ctl"], "--profile", windows_path(self.hyrax.profile), "repl")
        self.addCleanup(console.end)
        console.wait_for_text(":quit ends.\n>")
        for line, answer in (
            ("6 * 7", "6 * 7\n42\n"),
            ("word = 'äß€'", "\n>"),
            ("word", 'word\n"äß€"\n'),
            ("for i = 8, 9 do", "\n>>"),
            ("print(i) end", "8\n9\n"),
            ("nope.x = 1", "nil value (global 'nope')"),
            ("#word", "#word\n7\n"),
        ):
            console.enter(line)
            console.wait_for_text(answer)
        console.enter(":quit")
        self.assertEqual(console.wait(), 1)  # since a line failed

    def test_an_open_menu_holds_no_client_up(self):
        self.hyrax.wait_for_pets(lambda pets: len(pets) == 1)
        self.open_menu()
        question = self.start("status")
        # Of these seconds most go by until Wine has started the client.
        self.assertEqual(question.wait(20), 0)
        self.assertEqual(json.loads(question.text())["result"]["pets"], 1)
        self.result("spawn")
        self.hyrax.wait_for_pets(lambda pets: len(pets) == 2, 10, "the second pet beside the menu")
        self.assertEqual(len(self.menus()), 1)
        self.assertEqual(self.result("quit"), {})
        self.assertEqual(self.hyrax.program.wait(10), 0)

    def test_clients_cost_no_frame(self):
        self.hyrax.wait_for_pets(lambda pets: len(pets) == 1)
        quiet = self.frame_rate(lambda: time.sleep(3.0))
        # Programs that start take the machine's time, but the daemon waits for none of them.
        busy = self.frame_rate(lambda: [self.result("list") for _ in range(5)])
        self.assertGreater(busy, 0.2 * quiet)

    def frame_rate(self, act):
        """Frames that the daemon draws in a second, while this is done."""
        first, begin = self.result("status")["frames"], time.monotonic()
        act()
        return (self.result("status")["frames"] - first) / (time.monotonic() - begin)


class Plugins(fixture.OnDesktop):
    """hyraxctl.exe alone."""

    def setUp(self):
        super().setUp()
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.profile = self.folder / "profile"
        self.plugins = self.profile / "plugins"
        self.plugins.mkdir(parents=True)
        self.plugin("new", "catch-me", "--into", windows_path(self.folder))
        self.made = self.folder / "catch-me"

    def plugin(self, *arguments, code=0):
        return self.text_of(self.program("ctl", "--profile", windows_path(self.profile), "plugin", *arguments), code)

    def zipped(self, *more):
        """A zip file of what was made, and more entries of (name or ZipInfo, text)."""
        path = self.folder / "catch-mé.zip"
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
            for file in self.made.iterdir():
                archive.write(file, f"catch-me-main/{file.name}")
            for entry, text in more:
                archive.writestr(entry, text)
        return path

    def test_zip_files(self):
        self.plugin("install", windows_path(self.zipped()))
        main = self.plugins / "catch-me" / "main.lua"
        self.assertEqual(main.read_bytes(), (self.made / "main.lua").read_bytes())
        self.assertIn("--replace", self.plugin("install", windows_path(self.zipped()), code=1))
        self.plugin("remove", "catch-me", "--yes")
        link = zipfile.ZipInfo("link.lua")
        link.create_system = 3
        link.external_attr = (stat.S_IFLNK | 0o777) << 16
        for entry, text, said in (
            ("../evil.lua", "x", "safe"),
            ("/evil.lua", "x", "safe"),
            ("C:/evil.lua", "x", "safe"),
            ("aux.lua", "x", "safe"),
            ("bomb.txt", "0" * (33 << 20), "32 MiB"),
            (link, "/etc/passwd", "is a link"),
        ):
            with self.subTest(entry=entry):
                self.assertIn(said, self.plugin("install", windows_path(self.zipped((entry, text))), code=1))
                self.assertEqual(list(self.plugins.iterdir()), [])
        whole = self.zipped()
        for length in (0, 10, whole.stat().st_size // 2):
            whole.write_bytes(whole.read_bytes()[:length])
            self.assertIn("neither a folder nor a zip file", self.plugin("install", windows_path(whole), code=1))
            whole = self.zipped()
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["catch-me", whole.name, "profile"])

    def test_links_to_folders_are_not_followed(self):
        # Wine shows what links to a folder here as what Windows calls a reparse point.
        outside = self.folder / "outside"
        outside.mkdir()
        (outside / "file.lua").write_text("stays")
        (self.made / "lib").symlink_to(outside)
        said = "lib: is a link, but not to a file of the plugin"
        self.assertIn(said, self.plugin("check", windows_path(self.made), code=1))
        self.assertIn(said, self.plugin("install", windows_path(self.made), code=1))
        self.assertEqual(list(self.plugins.iterdir()), [])
        self.made.rename(self.plugins / "catch-me")
        # Wine lets no program remove such a link; Windows does.
        self.assertIn("cannot be removed", self.plugin("remove", "catch-me", "--yes", code=1))
        self.assertEqual((outside / "file.lua").read_text(), "stays")


if __name__ == "__main__":
    fixture.main("hyrax", "ctl")
