#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the shipped config, sprite sets and plugins against their JSON schemas, and that the schemas refuse
what is wrong. Needs Debian's python3-jsonschema. Run: python3 tests/config/validate.py
"""

import copy
import json
import pathlib
import sys
import unittest

import jsonschema

CONFIG = pathlib.Path(__file__).resolve().parents[2] / "config"


def without_comments(text):
    """Blanks out // and /* */ outside of strings; keeps every line and column."""
    result = []
    state = "json"
    at = 0
    while at < len(text):
        two = text[at:at + 2]
        if state == "json" and two in ("//", "/*"):
            state = two
        elif state == "json" and text[at] == '"':
            state = "string"
        elif state == "string" and text[at] == "\\":
            result.append(two)
            at += 2
            continue
        elif state == "string" and text[at] == '"':
            state = "json"
        elif state == "//" and text[at] == "\n":
            state = "json"
        elif state == "/*" and two == "*/":
            result.append("  ")
            at += 2
            state = "json"
            continue
        blank = state in ("//", "/*") and text[at] != "\n"
        result.append(" " if blank else text[at])
        at += 1
    return "".join(result)


def unique_keys(pairs):
    keys = [key for key, _ in pairs]
    if len(keys) != len(set(keys)):
        raise ValueError(f"a key twice: {keys}")
    return dict(pairs)


def load(path):
    return json.loads(without_comments(path.read_text("utf-8")), object_pairs_hook=unique_keys)


def validator(name):
    schema = load(CONFIG / name)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def changed(document, pointer, value):
    """A copy with the value at a pointer such as /pets/start/0/kind replaced or added."""
    result = copy.deepcopy(document)
    *path, last = [int(step) if step.isdigit() else step for step in pointer.split("/")[1:]]
    target = result
    for step in path:
        target = target[step]
    target[last] = value
    return result


class Comments(unittest.TestCase):
    def test_only_comments_are_blanked(self):
        text = '{"a//b": "/*c\\"//*/", // d "e"\n/* f\n"g" */"h": 1}'
        self.assertEqual(
            without_comments(text),
            '{"a//b": "/*c\\"//*/",         \n    \n      "h": 1}')


class Config(unittest.TestCase):
    def setUp(self):
        self.schema = validator("schema.json")
        self.config = load(CONFIG / "config.json")

    def test_shipped_config_is_valid(self):
        self.schema.validate(self.config)

    def test_shipped_config_points_to_its_schema(self):
        self.assertTrue((CONFIG / self.config["$schema"]).samefile(CONFIG / "schema.json"))

    def test_broken_configs_are_refused(self):
        broken = {
            "/physics": 5,
            "/physics/gravity": "high",
            "/pets/max_speed": 0,
            "/physics/restitution": 1.5,
            "/physics/air_drag": -0.1,
            "/pets/max": 0,
            "/pets/start/0/count": 1.5,
            "/pets/start/0/kind": "../hyrax",
            "/pets/start/0/x": 5,  # without y
            "/overlay/floor": "ceiling",
            "/overlay/ledges": True,
            "/overlay/fps": None,
            "/scripts/run": "*.lua",
            "/scripts/run/0": "a/../../b.lua",
            "/plugins": [],
            "/plugins/catch": True,
            "/log/level": "loud",
            "/hotkeys/gather": "ctrl/g",
        }
        for pointer, value in broken.items():
            with self.subTest(pointer):
                self.assertFalse(self.schema.is_valid(changed(self.config, pointer, value)))

    def test_harmless_changes_are_accepted(self):
        harmless = {
            "/unknown": 1,
            "/plugins/catch": {"enabled": True, "seconds": 30},
            "/physics/gravity": 300.5,
            "/pets/start/0": {"x": 5, "y": 6, "vx": -7},
            "/scripts/run": ["examples/*.lua", "a..b/c?.lua"],
        }
        for pointer, value in harmless.items():
            with self.subTest(pointer):
                self.schema.validate(changed(self.config, pointer, value))


class Sprites(unittest.TestCase):
    def setUp(self):
        self.schema = validator("sprite.schema.json")
        self.files = sorted(CONFIG.glob("sprites/*/sprite.json"))

    def test_shipped_sets_are_valid(self):
        self.assertTrue(self.files, "no sprite set is shipped")
        for file in self.files:
            with self.subTest(file.parent.name):
                sprite = load(file)
                self.schema.validate(sprite)
                self.assertTrue(
                    (file.parent / sprite["$schema"]).samefile(CONFIG / "sprite.schema.json"))
                self.assertTrue((file.parent / sprite["sheet"]).is_file())

    def test_broken_sets_are_refused(self):
        sprite = load(self.files[0])
        broken = {
            "/sheet": "../sheet.png",
            "/cell/width": 0,
            "/cell": {"width": 128},
            "/box/height": "92",
            "/anchor/x": -1,
            "/animations": {},
            "/animations/idle/frames": [],
            "/animations/idle/frames/0/ms": 0,
            "/animations/idle/frames/0/cell": -1,
            "/animations/extra": {"loop": True},
        }
        for pointer, value in broken.items():
            with self.subTest(pointer):
                self.assertFalse(self.schema.is_valid(changed(sprite, pointer, value)))


class Plugins(unittest.TestCase):
    MANIFEST = {
        "manifest": 1, "id": "rock-concert", "version": "1.2.0", "api": "1.0", "name": "Rock Concert",
        "entry": "main.lua", "permissions": ["hotkeys"], "kinds": {"rocker": "rocker/sprite.json"},
        "config": [{"key": "jumps", "type": "integer", "default": 5, "min": 1, "max": 20}],
        "on_reload": "keep",
    }

    def setUp(self):
        self.schema = validator("plugin.schema.json")

    def test_shipped_plugins_are_valid(self):
        files = sorted((CONFIG.parent / "scripts/plugins").glob("*/plugin.json"))
        self.assertTrue(files, "no plugin is shipped")
        for file in files:
            with self.subTest(file.parent.name):
                manifest = load(file)
                self.schema.validate(manifest)
                self.assertEqual(manifest["id"], file.parent.name)
                self.assertTrue(
                    (file.parent / manifest["$schema"]).samefile(CONFIG / "plugin.schema.json"))
                for sprite in manifest.get("kinds", {}).values():
                    validator("sprite.schema.json").validate(load(file.parent / sprite))

    def test_a_manifest_is_valid(self):
        self.schema.validate(self.MANIFEST)

    def test_broken_manifests_are_refused(self):
        broken = {
            "/manifest": 2,
            "/id": "nul",
            "/version": "1.2",
            "/api": "2.0",
            "/name": "",
            "/entry": "../main.lua",
            "/permissions/0": "network",
            "/kinds/Rocker": "rocker/sprite.json",
            "/kinds/rocker": "rocker/sheet.png",
            "/config/0/key": "enabled",
            "/config/0/type": "int",
            "/config/0/default": [],
            "/on_reload": True,
        }
        for pointer, value in broken.items():
            with self.subTest(pointer):
                self.assertFalse(self.schema.is_valid(changed(self.MANIFEST, pointer, value)))


if __name__ == "__main__":
    sys.exit(unittest.main())
