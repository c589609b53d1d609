# SPDX-License-Identifier: MIT
"""What docs/scripting.md tells to do, done in an empty profile: tutorial_test.py <hyrax-headless> <hyraxctl>

Every script of the first chapters is saved and runs; every command is given, in the order of the text, and answers as the
text shows, numbers aside.
"""
import pathlib
import re
import shlex
import shutil
import subprocess
import unittest

from served import CTL, HEADLESS, Served

ROOT = pathlib.Path(__file__).resolve().parents[2]
GUIDE = ROOT / "docs" / "scripting.md"


def steps():
    """(kind, text): "lua", "json" and "" for blocks, "command" for one in the text, "chapter" for a heading."""
    text = GUIDE.read_text().split("## Reference")[0]
    parts = re.split(r"^```(\w*)\n(.*?)^```$", text, flags=re.MULTILINE | re.DOTALL)
    for i in range(0, len(parts), 3):
        for heading, command in re.findall(r"^## (.*)$|`((?:hyraxctl|hyrax-headless)\s[^`]+)`", parts[i], re.MULTILINE):
            yield ("chapter", heading) if heading else ("command", " ".join(command.split()))
        if i + 2 < len(parts):
            yield parts[i + 1], parts[i + 2]


def without_numbers(text):
    return re.sub(r"\d+(\.\d+)?", "N", text)


class Tutorial(Served):
    """A user who has nothing yet, and works in the profile's folder."""

    config = "{}"

    def setUp(self):
        super().setUp()
        self.commands = 0

    def save(self, name, text):
        path = self.profile / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def do(self, command, typed=""):
        """What it prints; its first word is one of the two programs."""
        self.commands += 1
        words = shlex.split(command)
        start = [CTL, "--profile", self.profile] if words[0] == "hyraxctl" else [HEADLESS]
        done = subprocess.run(
            [*start, *words[1:]], cwd=self.profile, env=self.environment, input=typed, capture_output=True, text=True, timeout=60
        )  # fmt: skip
        self.assertEqual(done.returncode, 0, f"{command}: {done.stderr}")
        return done.stdout

    def transcript(self, text):
        """A terminal: commands after $, what is typed after >, and what is answered."""
        for command, rest in re.findall(r"^\$ (.*)\n((?:[^$].*\n)*)", text, re.MULTILINE):
            lines = rest.splitlines(keepends=True)
            typed = "".join(re.sub(r"^>>? ", "", line) for line in lines if line.startswith(">"))
            shown = "".join(line for line in lines if not line.startswith(">"))
            self.assertEqual(without_numbers(self.do(command, typed)), without_numbers(shown), command)

    def runs(self, name):
        self.result("reload")
        (script,) = (s for s in self.result("scripts")["scripts"] if s["name"] == name)
        self.assertEqual((script["state"], script["error"]), ("on", ""))

    def test_the_guide_as_it_stands(self):
        chapter, scripts, late = "", 0, []
        for kind, text in steps():
            with self.subTest(chapter=chapter, text=text[:60]):
                if kind == "chapter":
                    chapter = text
                    if chapter == "Trying things out":
                        self.do("hyraxctl config set scripts.developer true")
                        self.save("idea.lua", "hyrax.spawn()\n")
                elif kind == "command" and chapter == "Tests of a script":
                    late.append(text)  # The text shows the script after it.
                elif kind == "command":
                    self.do(text)
                elif kind == "lua" and chapter in ("The first line", "A game in seven steps", "Tests of a script"):
                    name = "hello.lua" if chapter == "The first line" else "ball.lua"
                    self.save(f"scripts/{name}", text)
                    self.save(name, text)
                    self.runs(name)
                    scripts += 1
                    for command in late:
                        self.do(command)
                elif kind == "json" and text.startswith("{"):
                    self.save("plugins/rock-concert/plugin.json", text)
                    self.save(
                        "plugins/rock-concert/main.lua",
                        'require("band").play()\n'
                        'if hyrax.test then hyrax.test.case("it plays", require("band").play) end\n',
                    )
                    self.save("plugins/rock-concert/band.lua", 'return { play = function() hyrax.spawn{ kind = "rocker" } end }\n')
                    shutil.copytree(ROOT / "config/sprites/hyrax", self.profile / "plugins/rock-concert/sprites/rocker")
                    self.result("reload")
                elif kind == "" and text.startswith("$ "):
                    self.transcript(text)
        self.assertEqual(scripts, 9)
        self.assertGreaterEqual(self.commands, 10)
        (rock,) = (p for p in self.result("plugins")["plugins"] if p["id"] == "rock-concert")
        self.assertEqual((rock["state"], rock["error"], rock["pets"]), ("on", "", 1))


unittest.main()
