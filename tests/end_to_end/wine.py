# SPDX-License-Identifier: MIT
"""Wine prefixes of the build tree: made once, cloned in a moment, ended without touching others."""

import fcntl
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDER = Path(os.environ.get("HYRAX_BUILD", ROOT / "build")) / "wine"
TEMPLATE = FOLDER / "template"


def environment(prefix, display=None):
    """The variables under which Wine runs: this prefix, no downloads, no chatter."""
    variables = {name: value for name, value in os.environ.items() if name != "WAYLAND_DISPLAY"}
    variables.update(WINEPREFIX=str(prefix), WINEDLLOVERRIDES="mscoree,mshtml=")
    variables.setdefault("WINEDEBUG", "-all")
    variables.pop("DISPLAY", None)
    if display:
        variables["DISPLAY"] = display
    return variables


def template():
    """The prefix that all others are clones of; making it takes 15 seconds."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    with open(FOLDER / "template.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (TEMPLATE / ".ready").exists():
            print("making a Wine prefix (15 seconds) ...", file=sys.stderr, flush=True)
            shutil.rmtree(TEMPLATE, ignore_errors=True)
            run = subprocess.run(
                ["wine", "wineboot", "--init"], env=environment(TEMPLATE), capture_output=True, timeout=300
            )
            subprocess.run(["wineserver", "-w"], env=environment(TEMPLATE), timeout=300, check=False)
            if not (TEMPLATE / "system.reg").exists():
                raise RuntimeError(f"wineboot made no prefix: {run.stderr.decode(errors='replace')[-500:]}")
            (TEMPLATE / ".ready").touch()
    return TEMPLATE


def clone(registry="", to=None):
    """A prefix of one's own, at `to` if given. Wine's DLLs, 700 MB, are hard links: no program
    writes to them."""
    source = template()
    _remove_left_overs()
    target = Path(tempfile.mkdtemp(prefix=f"prefix-{os.getpid()}-", dir=FOLDER))

    def link_or_copy(old, new):
        if "/drive_c/windows/" in old:
            os.link(old, new)
        else:
            shutil.copy2(old, new)

    shutil.copytree(source, target, symlinks=True, copy_function=link_or_copy, dirs_exist_ok=True)
    if registry:
        with open(target / "user.reg", "a", encoding="utf-8") as file:
            file.write("\n" + registry)
    if to:
        try:
            target.rename(to)
        except OSError:  # another was quicker
            shutil.rmtree(target)
        return Path(to)
    return target


def _remove_left_overs():
    """Of tests that were killed before they could tidy up."""
    for folder in FOLDER.glob("prefix-*-*"):
        if not Path("/proc", folder.name.split("-")[1]).exists() and not processes(folder):
            shutil.rmtree(folder, ignore_errors=True)


def processes(prefix):
    """(pid, command line) of all that run in this prefix, its wineserver included."""
    found = []
    for folder in Path("/proc").iterdir():
        if not folder.name.isdigit():
            continue
        try:
            if f"WINEPREFIX={prefix}".encode() in (folder / "environ").read_bytes().split(b"\0"):
                line = (folder / "cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
                if line and (folder / "stat").read_text().rsplit(")", 1)[1].split()[0] != "Z":
                    found.append((int(folder.name), line.strip()))
        except OSError:
            pass  # it ended while it was looked at, or is another user's
    return found


def end(prefix):
    """Ends all programs of this prefix, and none of another's."""
    subprocess.run(["wineserver", "-k"], env=environment(prefix), capture_output=True, timeout=60, check=False)


def remove(prefix):
    end(prefix)
    shutil.rmtree(prefix, ignore_errors=True)


def keep_server(prefix):
    """Has Wine's server wait a minute for further programs, unless end() comes first. Debian's ends with its
    last program, and a program that starts meanwhile meets one that is dying."""
    subprocess.run(
        ["wineserver", "-p60"], env=environment(prefix), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL, timeout=60, check=True,
    )  # fmt: skip


def windows_path(path):
    """How a Windows program names a file of this machine."""
    return "Z:" + str(Path(path).resolve()).replace("/", "\\")


if __name__ == "__main__":  # wine.py FOLDER makes a prefix there
    clone(to=sys.argv[1])
