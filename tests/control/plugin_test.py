# SPDX-License-Identifier: MIT
"""hyraxctl plugin: plugin_test.py <hyraxctl>"""
import pathlib
import re
import resource
import stat
import struct
import subprocess
import sys
import tempfile
import unittest
import zipfile
import zlib

CTL = pathlib.Path(sys.argv[1])
del sys.argv[1]


def lying_png(width, height):
    """A whole PNG file that says it is so large, and holds one row of one byte."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    rows = chunk(b"IDAT", zlib.compress(b"\0"))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + rows + chunk(b"IEND", b"")


class Plugins(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.profile = self.folder / "profile"
        self.installed = self.profile / "plugins" / "catch-me"
        done = self.plugin("new", "catch-me", "--into", self.folder)
        self.assertEqual((done.returncode, done.stdout), (0, f"{self.folder}/catch-me\n"))
        self.made = self.folder / "catch-me"

    def plugin(self, *arguments, typed=""):
        command = [CTL, "--profile", self.profile, "plugin", *map(str, arguments)]
        return subprocess.run(command, input=typed, capture_output=True, text=True, timeout=120)

    def refused(self, *arguments):
        done = self.plugin(*arguments)
        self.assertEqual((done.returncode, done.stdout), (1, ""), done.stderr)
        return done.stderr

    def zipped(self, files, name="catch-me.zip"):
        """A zip file of (name or ZipInfo, text)."""
        path = self.folder / name
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
            for entry, text in files:
                archive.writestr(entry, text)
        return path

    def good_files(self, prefix=""):
        return [(prefix + p.name, p.read_text()) for p in sorted(self.made.iterdir())]

    def nothing_is_left(self):
        self.assertEqual(list((self.profile / "plugins").iterdir()), [])


class New(Plugins):
    def test_the_template_passes_the_check_unchanged(self):
        done = self.plugin("check", self.made)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"good: it ran for a minute; 1 cases passed\n")

    def test_ids_and_folders_that_are_there_are_refused(self):
        self.assertIn("is no id of a plugin", self.refused("new", "No", "--into", self.folder))
        self.assertIn("is there already", self.refused("new", "catch-me", "--into", self.folder))


class Check(Plugins):
    def check_with(self, text):
        (self.made / "main.lua").write_text(text)
        done = self.plugin("check", self.made)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        return done.stderr

    def test_errors_are_told_as_compilers_do(self):
        main = re.escape(str(self.made / "main.lua"))
        self.assertRegex(self.check_with("local x =\n"), rf"(?m)^error: {main}:\d: unexpected symbol near <eof>$")
        self.assertRegex(self.check_with("\nerror('oh')\n"), rf"(?m)^error: {main}:2: oh$")
        late = "hyrax.after(50, function()\n  nope.x = 1\nend)\n"
        self.assertRegex(self.check_with(late), rf"(?m)^error: {main}:2: attempt to index a nil value")
        self.assertRegex(self.check_with("while true do end"), rf"(?m)^error: {main}:1: used more than")
        click = "hyrax.on('click', function() error('clicked') end)"
        self.assertRegex(self.check_with(click), rf"(?m)^error: {main}:1: clicked$")

    def test_cases_that_fail_are_errors(self):
        text = "if hyrax.test then\n  hyrax.test.case('no', function()\n    hyrax.test.equal(1, 2)\n  end)\nend\n"
        said = self.check_with(text)
        self.assertRegex(said, r'(?m)^error: .*main\.lua:3: expected 2, got 1 \(in the case "no"\)$')

    def test_a_wrong_manifest_is_told_by_line_and_column(self):
        manifest = self.made / "plugin.json"
        manifest.write_text(manifest.read_text().replace('"0.1.0"', "5"))
        done = self.plugin("check", self.made)
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"error: {manifest}:4:", done.stderr)
        self.assertIn("plugin.json", self.plugin("check", self.folder).stderr)


    def test_pictures_that_lie_about_their_size(self):
        manifest = self.made / "plugin.json"
        manifest.write_text(manifest.read_text().replace('"permissions"', '"kinds": {"big": "sprite.json"}, "permissions"'))
        (self.made / "sprite.json").write_text(
            '{"sheet": "sheet.png", "cell": {"width": 64, "height": 64},'
            ' "box": {"x": 0, "y": 0, "width": 64, "height": 64},'
            ' "animations": {"idle": {"frames": [{"cell": 0, "ms": 100}]}}}'
        )
        sheet = self.made / "sheet.png"
        for side in (4160, 65536, 2**31 - 64):
            sheet.write_bytes(lying_png(side, side))
            said = f"{sheet}: is {side} x {side} pixels; a plugin's pictures have at most 4096 a side\n"
            self.assertEqual(self.plugin("check", self.made).stderr, f"error: {said}")
            self.assertIn(said, self.refused("install", self.made))
        sheet.write_bytes(lying_png(4096, 4096))
        self.assertIn("sheet.png: cannot be decoded: ", self.plugin("check", self.made).stderr)
        most = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        self.assertLess(most, 1 << 20, "KiB of memory")


class Install(Plugins):
    def test_a_folder_is_installed_replaced_and_removed(self):
        done = self.plugin("install", self.made)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, f"catch-me 0.1.0 in {self.installed}\n")
        self.assertEqual((self.installed / "main.lua").read_text(), (self.made / "main.lua").read_text())
        self.assertIn("--replace", self.refused("install", self.made))
        self.assertEqual(self.plugin("install", self.made, "--replace").returncode, 0)
        self.assertEqual(self.plugin("remove", "catch-me", typed="no\n").returncode, 1)
        self.assertTrue(self.installed.exists())
        self.assertEqual(self.plugin("remove", "catch-me", typed="y\n").returncode, 0)
        self.nothing_is_left()
        self.assertIn("there is no plugin", self.refused("remove", "catch-me", "--yes"))

    def test_zip_files_with_and_without_a_folder(self):
        self.assertEqual(self.plugin("install", self.zipped(self.good_files())).returncode, 0)
        self.assertTrue((self.installed / "plugin.json").exists())
        done = self.plugin("install", self.zipped(self.good_files("catch-me-main/")), "--replace")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual([p.name for p in self.installed.parent.iterdir()], ["catch-me"])

    def test_evil_zip_files_leave_nothing(self):
        link = zipfile.ZipInfo("link.lua")
        link.create_system = 3
        link.external_attr = (stat.S_IFLNK | 0o777) << 16
        bomb = ("bomb.txt", "0" * (33 << 20))
        for name, said in (
            ("../evil.lua", "safe"),
            ("a/../../evil.lua", "safe"),
            ("/tmp/evil.lua", "safe"),
            ("C:/evil.lua", "safe"),
            ("a\\..\\evil.lua", "safe"),
            ("aux.lua", "safe"),
            ("MAIN.LUA", "twice"),
        ):
            with self.subTest(name=name):
                self.assertIn(said, self.refused("install", self.zipped([*self.good_files(), (name, "x")])))
                self.nothing_is_left()
        self.assertIn("is a link", self.refused("install", self.zipped([*self.good_files(), (link, "/etc/passwd")])))
        self.assertIn("32 MiB", self.refused("install", self.zipped([*self.good_files(), bomb])))
        many = [(f"file{i}.txt", "") for i in range(201)]
        self.assertIn("200 files", self.refused("install", self.zipped([*self.good_files(), *many])))
        self.nothing_is_left()
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["catch-me", "catch-me.zip", "profile"])

    def test_broken_and_encrypted_zip_files(self):
        path = self.zipped(self.good_files())
        whole = path.read_bytes()
        # The flag of encryption, in each header and in the directory.
        locked = bytearray(whole)
        for mark, at in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
            place = locked.find(mark)
            while place >= 0:
                locked[place + at] |= 1
                place = locked.find(mark, place + 4)
        path.write_bytes(locked)
        self.assertIn("is encrypted", self.refused("install", path))
        # A header that lies about the size is not believed, nor is a wrong checksum.
        wrong = bytearray(whole)
        wrong[wrong.find(b"PK\x01\x02") + 16] ^= 0xFF
        path.write_bytes(wrong)
        self.assertIn("broken", self.refused("install", path))
        for length in (0, 10, len(whole) // 2, len(whole) - 30):
            path.write_bytes(whole[:length])
            self.assertNotEqual(self.refused("install", path), "")
        self.nothing_is_left()


if __name__ == "__main__":
    unittest.main()
