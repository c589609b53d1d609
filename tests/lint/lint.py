#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The house rules that a machine can check. Each prints FILE:LINE: what is wrong, and exits with 1.

lint.py includes         who may include whom (the table ROOMS below)
lint.py length           no source file above 400 lines
lint.py licence          an SPDX line at the top of each source file
lint.py ifdef            no question about the operating system in C++
lint.py format           clang-format finds nothing to change
lint.py imports EXE...   a Windows program imports system DLLs only, and is hardened
lint.py --self-test      each rule fires on a small tree that breaks it
"""

import argparse
import functools
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

MAX_LINES = 400
CLANG_FORMAT = "18.1.8"

# What each room may include, by the kinds that kind_of() tells. The longest prefix decides.
ROOMS = {
    "physics/": {"std", "intrinsics", "physics"},
    "daemon/core/": {"std", "intrinsics", "physics", "core", "log"},
    "daemon/script/": {"std", "physics", "script", "core", "log", "lua"},
    "daemon/check/": {"std", "check", "core", "script", "log"},
    "daemon/control/": {"std", "control", "core", "log", "json", "cli", "minizip"},
    "daemon/win32/": {"std", "physics", "win32", "core", "control", "log", "windows"},
    "daemon/headless/": {"std", "physics", "headless", "core", "control", "log", "posix", "png", "freetype", "seccomp"},
    "daemon/main_": {"std", "physics", "core", "script", "control", "check", "win32", "headless", "log", "cli", "windows", "posix"},
    "tests/": None,  # anything
}
# Only these files of daemon/core may see nlohmann, and only they may include each other's headers.
JSON_FILE = re.compile(r"^daemon/core/\w+_json\.(h|cpp)$")
# Scripts get plain data; the engine's insides are behind the bridge.
ENGINE = {"daemon/core/engine.h", "daemon/core/daemon.h", "daemon/core/pet.h", "daemon/core/script_bridge.h"}

THIRD_PARTIES = [
    (re.compile(r"^nlohmann/"), "json"),
    (re.compile(r"^(spdlog|fmt)/"), "log"),
    (re.compile(r"^(sol/.*|lua\w*\.h(pp)?|lauxlib\.h)$"), "lua"),
    (re.compile(r"^l(api|code|ctype|debug|do|func|gc|limits|mem|object|opcodes|state|string|table|tm|vm|zio)\.h$"), "lua"),
    (re.compile(r"^CLI/"), "cli"),
    (re.compile(r"^doctest/"), "doctest"),
    (re.compile(r"^png\w*\.h$"), "png"),
    (re.compile(r"^freetype/.*"), "freetype"),
    (re.compile(r"^seccomp\.h$"), "seccomp"),
    (re.compile(r"^minizip/"), "minizip"),
    (re.compile(r"^\w+intrin\.h$"), "intrinsics"),
    (re.compile(r"^((sys|arpa|netinet|linux)/.*|(unistd|fcntl|poll|signal|pthread|dirent|spawn|dlfcn|time)\.h)$"), "posix"),
    (re.compile(r"^[a-z0-9_]+$"), "std"),
    (re.compile(r"^[A-Za-z0-9_]+\.h$"), "windows"),
]

SYSTEM_QUESTION = re.compile(r"\b(_WIN32|_WIN64|__MINGW32__|__MINGW64__|__linux__|__unix__)\b")

# Windows' known DLLs, which cannot be planted beside the program; msvcrt is the C library.
SYSTEM_DLLS = {
    "advapi32.dll", "gdi32.dll", "gdiplus.dll", "kernel32.dll", "msvcrt.dll", "ole32.dll", "oleaut32.dll",
    "shcore.dll", "shell32.dll", "shlwapi.dll", "user32.dll",
}  # fmt: skip
# After SetLayeredWindowAttributes every UpdateLayeredWindow fails; timeBeginPeriod costs battery.
FORBIDDEN_IMPORTS = {"SetLayeredWindowAttributes", "timeBeginPeriod"}
DLL_CHARACTERISTICS = {
    0x0020: "HIGH_ENTROPY_VA",
    0x0040: "DYNAMIC_BASE",
    0x0100: "NX_COMPAT",
    0x8000: "TERMINAL_SERVER_AWARE",
}


@functools.lru_cache
def files(root):
    """All files that belong to the project, as paths relative to its root."""
    if (root / ".git").exists():
        command = ["git", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
        names = subprocess.run(command, capture_output=True, check=True).stdout.decode().split("\0")
        return sorted({name for name in names if name and (root / name).is_file()})
    found = []
    for folder, folders, names in os.walk(root):
        folders[:] = [f for f in folders if f not in ("build", ".git", "__pycache__")]
        found += [(Path(folder) / name).relative_to(root).as_posix() for name in names]
    return sorted(found)


def is_cpp(name):
    return name.endswith((".h", ".cpp"))


def is_source(name):
    own = name in ("dev", ".ci/run", "cmake/wine-run") or name.endswith("CMakeLists.txt")
    return own or is_cpp(name) or name.endswith((".py", ".lua", ".sh", ".cmake", ".rc", ".nsi"))


def lines_of(root, name):
    return (root / name).read_text(encoding="utf-8", errors="replace").splitlines()


# --- includes -------------------------------------------------------------------------------------


def kind_of(target, quoted):
    """The kind of an included file, or None where it cannot be told."""
    if quoted:
        match = re.match(r"^(physics|tests)/|^daemon/(check|core|script|control|win32|headless)/", target)
        return (match.group(1) or match.group(2)) if match else None
    return next((kind for pattern, kind in THIRD_PARTIES if pattern.match(target)), None)


def why_not(name, target, quoted):
    """What is wrong with this include, or None."""
    room = max((r for r in ROOMS if name.startswith(r)), key=len, default=None)
    if room is None:
        return f"{name} is in no room of the table"
    allowed = ROOMS[room]
    kind = kind_of(target, quoted)
    if kind is None and quoted:
        return f'"{target}" is not a path from the root of the project'
    if allowed is None:
        return None
    if kind == "json" or JSON_FILE.match(target):
        if room == "daemon/core/" and JSON_FILE.match(name):
            return None
        if room == "daemon/core/":
            return f"{target}: in daemon/core only files named *_json.h and *_json.cpp may use nlohmann"
    if room == "daemon/script/" and target in ENGINE:
        return f"{target}: scripts get plain data, not the engine's insides"
    if kind not in allowed:
        return f"{target}: {room.rstrip('/_')} must not use {kind or 'this'}"
    return None


def check_includes(root):
    directive = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
    for name in filter(is_cpp, files(root)):
        for number, line in enumerate(lines_of(root, name), 1):
            if match := directive.match(line):
                if problem := why_not(name, match.group(2), match.group(1) == '"'):
                    yield f"{name}:{number}: {problem}"


# --- the smaller rules ----------------------------------------------------------------------------


def check_length(root):
    for name in filter(is_source, files(root)):
        if (count := len(lines_of(root, name))) > MAX_LINES:
            yield f"{name}:{MAX_LINES}: the file has {count} lines, at most {MAX_LINES} are allowed"


def check_licence(root):
    for name in filter(is_source, files(root)):
        # A script has its #! first, a batch of XML its prolog.
        if not any("SPDX-License-Identifier: MIT" in line for line in lines_of(root, name)[:2]):
            yield f"{name}:1: no line with SPDX-License-Identifier: MIT"


def check_ifdef(root):
    for name in filter(is_cpp, files(root)):
        for number, line in enumerate(lines_of(root, name), 1):
            if match := SYSTEM_QUESTION.search(line):
                yield f"{name}:{number}: {match.group(1)}: the build picks the room, sources do not ask"


def clang_format(root):
    """The path of the pinned version."""
    staged = root / "build" / "tools" / "clang_format" / "data" / "bin" / "clang-format"
    for candidate in (os.environ.get("HYRAX_CLANG_FORMAT"), staged, shutil.which("clang-format")):
        if candidate and Path(candidate).exists():
            version = subprocess.run([candidate, "--version"], capture_output=True, text=True, check=False)
            if f"version {CLANG_FORMAT}" in version.stdout:
                return str(candidate)
    sys.exit(f"error: clang-format {CLANG_FORMAT} is missing; `./dev format` fetches it")


def check_format(root, project=None):
    tool = clang_format(project or root)
    names = [name for name in files(root) if is_cpp(name)]
    if not names:
        return
    run = subprocess.run(
        [tool, "--dry-run", "-Werror", "-fno-color-diagnostics", *names],
        cwd=root, capture_output=True, text=True, check=False,
    )  # fmt: skip
    wrong = dict.fromkeys(re.findall(r"^(\S+?:\d+):\d+: error", run.stderr, re.MULTILINE))
    for place in wrong:
        yield f"{place}: not as clang-format writes it; `./dev format` mends it"
    if run.returncode != 0 and not wrong:
        yield f"clang-format failed: {run.stderr.strip()[:500]}"


# --- imports --------------------------------------------------------------------------------------


def judge_imports(name, dump):
    """Problems in what `objdump -p` prints of a program."""
    dlls = re.findall(r"^\s*DLL Name: (\S+)", dump, re.MULTILINE)
    if not dlls:
        yield f"{name}: no import table found"
    for dll in dlls:
        if dll.lower() not in SYSTEM_DLLS:
            yield f"{name}: imports {dll}, which is not among the known system DLLs"
    for function in re.findall(r"^\s+[0-9a-f]+\s+(?:<\w+>|\d+)\s+(\w+)", dump, re.MULTILINE):
        if function in FORBIDDEN_IMPORTS:
            yield f"{name}: imports {function}"
    flags = re.search(r"^DllCharacteristics\s+([0-9a-f]+)", dump, re.MULTILINE)
    value = int(flags.group(1), 16) if flags else 0
    for bit, meaning in DLL_CHARACTERISTICS.items():
        if not value & bit:
            yield f"{name}: DllCharacteristics {value:#x} lacks {meaning}"
    version = re.search(r"^MajorSubsystemVersion\s+(\d+)", dump, re.MULTILINE)
    if not version or int(version.group(1)) != 10:
        yield f"{name}: the subsystem version is not 10"


def check_imports(programs):
    tool = shutil.which("x86_64-w64-mingw32-objdump") or shutil.which("objdump")
    if not tool:
        sys.exit("error: objdump is missing (binutils-mingw-w64-x86-64)")
    for program in programs:
        run = subprocess.run([tool, "-p", program], capture_output=True, text=True, check=False)
        if run.returncode != 0:
            yield f"{program}: {run.stderr.strip()}"
        else:
            yield from judge_imports(program, run.stdout)


CHECKS = {
    "includes": check_includes,
    "length": check_length,
    "licence": check_licence,
    "ifdef": check_ifdef,
    "format": check_format,
}


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("rule", nargs="?", choices=[*CHECKS, "imports"])
    options.add_argument("programs", nargs="*")
    options.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    options.add_argument("--self-test", action="store_true")
    options = options.parse_args()
    if options.self_test:
        import lint_self_test

        return lint_self_test.run(options.root)
    if options.rule is None or (options.rule == "imports") != bool(options.programs):
        sys.exit(__doc__)
    imports = options.rule == "imports"
    problems = list(check_imports(options.programs) if imports else CHECKS[options.rule](options.root))
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
