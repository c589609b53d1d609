#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Stages the third-party sources that dependencies.json pins into build/third_party/<name>/.

For each library the first source that serves wins: a folder given by the user, the system's package,
the upstream archive, a crate. What is staged already is checked by its hash and left alone.
Exit codes: 0 all staged, 1 a library could not be had, 3 as 1, and a working cargo would help.
"""

import argparse
import contextlib
import fnmatch
import hashlib
import io
import json
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time
import urllib.error
import urllib.parse
import urllib.request
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PINS = HERE / "dependencies.json"
STAMP = ".hyrax_stage.json"
CONNECT_SECONDS = 5  # an offline machine must not hang; upstream answers in well under a second
ARCHIVE_LIMIT = 64 << 20


class Unavailable(Exception):
    """This source cannot serve; the next one is tried."""


class NeedsCargo(Unavailable):
    """A newer or any cargo would make this source work."""


def wanted_files(folder, pin):
    """Paths below `folder` that are staged, sorted, in POSIX form."""
    found = set()
    for pattern in pin["files"]:
        found.update(p.relative_to(folder).as_posix() for p in folder.glob(pattern) if p.is_file())
    return sorted(n for n in found if not any(fnmatch.fnmatch(n, w) for w in pin["without"]))


def tree_hash(folder, names):
    """SHA-256 over names and contents; line ends as they are."""
    total = hashlib.sha256()
    for name in names:
        content = hashlib.sha256((folder / name).read_bytes()).hexdigest()
        total.update(f"{name}\0{content}\n".encode())
    return total.hexdigest()


def pin_hash(pin):
    return hashlib.sha256(json.dumps(pin, sort_keys=True).encode()).hexdigest()


@contextlib.contextmanager
def only_one(stage):
    """Two configure runs at once would otherwise copy over each other."""
    stage.mkdir(parents=True, exist_ok=True)
    with open(stage / ".lock", "a+b") as lock:
        if os.name == "nt":
            import msvcrt

            while True:
                try:
                    msvcrt.locking(lock.fileno(), msvcrt.LK_LOCK, 1)
                    break
                except OSError:
                    time.sleep(1)
        else:
            import fcntl

            fcntl.flock(lock, fcntl.LOCK_EX)
        yield


# --- the four kinds of source: each returns a folder in which pin["files"] match -----------------


def from_user(name, pin, given, work):
    folder = given.get(name)
    if not folder:
        raise Unavailable("no folder given")
    for candidate in (folder, folder / "src", folder / "include"):
        if wanted_files(candidate, pin):
            return candidate
    # A folder that was asked for and is wrong must not be papered over by another source.
    sys.exit(f"error: {name}: HYRAX_{name.upper()}_DIR={folder} holds no {pin['files'][0]}")


def from_system(name, pin, given, work):
    system = pin.get("system")
    if not system:
        raise Unavailable("no system package")
    folder = Path(system["folder"])
    names = wanted_files(folder, pin)
    if not names:
        raise Unavailable(f"{system['package']} is not installed")
    if tree_hash(folder, names) not in pin["trees"].values():
        raise Unavailable(f"{system['package']} is not the pinned version {pin['version']}")
    return folder


unreachable_hosts = {}


def from_upstream(name, pin, given, work):
    url, digest = pin.get("archive"), pin.get("archive_sha256")
    if not url or not digest:
        raise Unavailable("upstream refused: no hash is pinned for its archive")
    host = urllib.parse.urlsplit(url).hostname
    if host in unreachable_hosts:
        raise Unavailable(unreachable_hosts[host])
    try:
        with urllib.request.urlopen(url, timeout=CONNECT_SECONDS) as answer:
            data = answer.read(ARCHIVE_LIMIT + 1)
    except urllib.error.HTTPError as problem:
        raise Unavailable(f"{url}: {problem.code} {problem.reason}") from None
    except (urllib.error.URLError, OSError) as problem:
        reason = getattr(problem, "reason", problem)
        unreachable_hosts[host] = f"{host} cannot be reached ({reason})"
        raise Unavailable(unreachable_hosts[host]) from None
    if hashlib.sha256(data).hexdigest() != digest:
        raise Unavailable(f"{url} does not have the pinned SHA-256")
    unpack(data, url, work)
    return work / pin["archive_folder"]


def unpack(data, url, folder):
    """The archive's hash is known by now; the names are checked all the same."""
    root = folder.resolve()

    def inside(name):
        return root in (root / name).resolve().parents

    if url.endswith(".zip"):
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            archive.extractall(folder, [n for n in archive.namelist() if inside(n)])
    else:
        with tarfile.open(fileobj=io.BytesIO(data)) as archive:
            plain = [m for m in archive.getmembers() if inside(m.name) and (m.isfile() or m.isdir())]
            archive.extractall(folder, plain)


def from_crate(name, pin, given, work):
    crate = pin.get("crate")
    if not crate:
        raise Unavailable("no crate")
    cargo = shutil.which("cargo")
    if not cargo:
        raise NeedsCargo("cargo is not installed")
    (work / "lib.rs").touch()
    (work / "Cargo.toml").write_text(
        '[package]\nname = "stage"\nversion = "0.0.0"\nedition = "2018"\n[lib]\npath = "lib.rs"\n'
        f'[dependencies]\n{crate["name"]} = "={crate["version"]}"\n',
        encoding="utf-8",
    )
    run = subprocess.run(
        [cargo, "vendor", "--quiet", "vendor"], cwd=work, capture_output=True, text=True, timeout=300
    )
    if run.returncode != 0:
        last = (run.stderr.strip().splitlines() or ["no message"])[-1].strip()
        raise NeedsCargo(f"cargo vendor failed: {last}")
    folder = work / "vendor" / crate["name"]
    checksum = json.loads((folder / ".cargo-checksum.json").read_text(encoding="utf-8"))
    if checksum.get("package") != crate["sha256"]:
        raise Unavailable(f"crate {crate['name']} does not have the pinned SHA-256")
    folder = folder / crate["folder"]
    if tree_hash(folder, wanted_files(folder, pin)) not in pin["trees"].values():
        raise Unavailable(f"crate {crate['name']} does not hold the pinned files")
    return folder


SOURCES = [
    ("user", from_user),
    ("system", from_system),
    ("upstream", from_upstream),
    ("crate", from_crate),
]


def origin(kind, name, pin, given):
    """What is printed after "from"."""
    return {
        "user": lambda: f"{given.get(name)} (given by the user, not verified)",
        "system": lambda: f"system package {pin['system']['package']}",
        "upstream": lambda: pin["archive"],
        "crate": lambda: f"crate {pin['crate']['name']} {pin['crate']['version']}",
    }[kind]()


def staged(target, pin, wish):
    """The stamp of what is staged, if that is complete and what is wished for; else None."""
    try:
        stamp = json.loads((target / STAMP).read_text(encoding="utf-8"))
        content = target / pin["into"]
        fits = stamp["pin"] == pin_hash(pin) and stamp["wish"] == wish
        if fits and stamp["tree"] == tree_hash(content, wanted_files(content, pin)):
            return stamp
    except (OSError, ValueError, KeyError):
        pass
    return None


def wish_of(name, pin, given):
    """Changes when the user gives another folder or edits the files in it."""
    if name not in given:
        return ""
    folder = from_user(name, pin, given, None)
    return f"{folder}:{tree_hash(folder, wanted_files(folder, pin))}"


def put(folder, target, pin, stamp):
    """Copies beside the target and renames, so that nobody ever sees half a library."""
    fresh = Path(tempfile.mkdtemp(prefix=f".{target.name}-", dir=target.parent))
    fresh.chmod(0o755)  # mkdtemp's 0700 would lock out another user of the same tree
    content = fresh / pin["into"]
    for name in wanted_files(folder, pin):
        (content / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(folder / name, content / name)  # keeps the time: no needless rebuild
    (fresh / STAMP).write_text(json.dumps(stamp, indent=1) + "\n", encoding="utf-8")
    shutil.rmtree(target, ignore_errors=True)
    fresh.rename(target)


def stage_one(name, pin, stage, given, verbose):
    target, wish = stage / name, wish_of(name, pin, given)
    stamp = staged(target, pin, wish)
    if stamp:
        if verbose:
            print(f"{name} {pin['version']}: staged before, from {stamp['from']}")
        return True, False
    problems, cargo_helps = [], False
    for kind, source in SOURCES:
        work = Path(tempfile.mkdtemp(prefix=f".work-{name}-", dir=stage))
        try:
            folder = source(name, pin, given, work)
            names = wanted_files(folder, pin)
            if not names:
                raise Unavailable(f"{kind} holds none of the files")
            where = origin(kind, name, pin, given)
            tree = tree_hash(folder, names)
            put(folder, target, pin, {"pin": pin_hash(pin), "wish": wish, "tree": tree, "from": where})
            print(f"{name} {pin['version']}: {len(names)} files from {where}", flush=True)
            return True, False
        except Unavailable as problem:
            cargo_helps = cargo_helps or isinstance(problem, NeedsCargo)
            if str(problem) not in ("no folder given", "no system package", "no crate"):
                problems.append(str(problem))
        finally:
            shutil.rmtree(work, ignore_errors=True)
    hint = f"or unpack {pin.get('archive', pin['home'])} and set HYRAX_{name.upper()}_DIR"
    print(f"error: {name} {pin['version']}: {'; '.join(problems)}; {hint}", file=sys.stderr)
    return False, cargo_helps


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--stage", type=Path, default=HERE.parent / "build" / "third_party")
    options.add_argument("--dir", action="append", default=[], metavar="NAME=FOLDER")
    options.add_argument("--quiet", action="store_true", help="say nothing about what is staged already")
    options.add_argument("--trees", action="store_true", help="print the hashes of what is staged")
    options = options.parse_args()
    pins = json.loads(PINS.read_text(encoding="utf-8"))["libraries"]

    given = {n: os.environ[f"HYRAX_{n.upper()}_DIR"] for n in pins if os.environ.get(f"HYRAX_{n.upper()}_DIR")}
    given.update(d.split("=", 1) for d in options.dir)
    given = {name: Path(folder).expanduser().resolve() for name, folder in given.items()}
    if unknown := set(given) - set(pins):
        sys.exit(f"error: --dir names no known library: {', '.join(sorted(unknown))}")

    with only_one(options.stage):
        for left_over in options.stage.glob(".*-*"):  # of a run that was killed
            shutil.rmtree(left_over, ignore_errors=True)
        results = [stage_one(n, p, options.stage, given, not options.quiet) for n, p in pins.items()]
        if options.trees:
            for name, pin in pins.items():
                print(name, json.loads((options.stage / name / STAMP).read_text())["tree"])
    if all(done for done, _ in results):
        return 0
    return 3 if any(cargo_helps for _, cargo_helps in results) else 1


if __name__ == "__main__":
    sys.exit(main())
