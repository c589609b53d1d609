# SPDX-License-Identifier: MIT
"""Proves on small trees that each rule of lint.py is silent on what is right and fires on what is not."""

import tempfile
from pathlib import Path

import lint

SPDX = "// SPDX-License-Identifier: MIT\n"

# (rule, file, content, words of the problem or None where there is none)
CASES = [
    ("includes", "physics/a.h", "#include <cmath>\n", None),
    ("includes", "physics/a.h", '#include "physics/b.h"\n#include <immintrin.h>\n', None),
    ("includes", "physics/a.h", "#include <spdlog/spdlog.h>\n", "must not use log"),
    ("includes", "physics/a.h", '#include "daemon/core/a.h"\n', "must not use core"),
    ("includes", "physics/a.cpp", "#include <unistd.h>\n", "must not use posix"),
    ("includes", "daemon/core/a.cpp", '#include "physics/a.h"\n#include <fmt/format.h>\n', None),
    ("includes", "daemon/core/a_json.cpp", "#include <nlohmann/json.hpp>\n", None),
    ("includes", "daemon/core/a_json.cpp", '#include "daemon/core/b_json.h"\n', None),
    ("includes", "daemon/core/a.cpp", "#include <nlohmann/json.hpp>\n", "only files named"),
    ("includes", "daemon/core/a.cpp", '#include "daemon/core/b_json.h"\n', "only files named"),
    ("includes", "daemon/core/a.cpp", "#include <windows.h>\n", "must not use windows"),
    ("includes", "daemon/core/a.cpp", "#include <sol/sol.hpp>\n", "must not use lua"),
    ("includes", "daemon/core/a.cpp", '#include "daemon/win32/a.h"\n', "must not use win32"),
    ("includes", "daemon/core/a.cpp", '#include "daemon/script/a.h"\n', "must not use script"),
    ("includes", "daemon/core/a.cpp", '#include "a.h"\n', "not a path from the root"),
    ("includes", "daemon/script/a.cpp", '#include "daemon/core/vec.h"\n#include <lauxlib.h>\n', None),
    ("includes", "daemon/script/a.cpp", '#include "daemon/core/engine.h"\n', "engine's insides"),
    ("includes", "daemon/script/a.cpp", '#include "daemon/headless/a.h"\n', "must not use headless"),
    ("includes", "daemon/script/a.cpp", "#include <shellapi.h>\n", "must not use windows"),
    ("includes", "daemon/control/a.cpp", "#include <nlohmann/json.hpp>\n#include <CLI/CLI.hpp>\n", None),
    ("includes", "daemon/control/a.cpp", "#include <lua.h>\n", "must not use lua"),
    ("includes", "daemon/win32/a.cpp", "#include <windows.h>\n#include <gdiplus.h>\n", None),
    ("includes", "daemon/win32/a.cpp", '#include "daemon/control/a.h"\n', None),
    ("includes", "daemon/win32/a.cpp", "#include <nlohmann/json.hpp>\n", "must not use json"),
    ("includes", "daemon/win32/a.cpp", '#include "daemon/script/a.h"\n', "must not use script"),
    ("includes", "daemon/headless/a.cpp", "#include <png.h>\n#include <sys/stat.h>\n", None),
    ("includes", "daemon/headless/a.cpp", "#include <windows.h>\n", "must not use windows"),
    ("includes", "daemon/main_a.cpp", '#include "daemon/win32/a.h"\n#include "daemon/script/a.h"\n', None),
    ("includes", "daemon/main_a.cpp", "#include <sol/sol.hpp>\n", "must not use lua"),
    ("includes", "tests/core/a.cpp", "#include <nlohmann/json.hpp>\n#include <doctest/doctest.h>\n", None),
    ("includes", "daemon/other/a.cpp", "#include <cmath>\n", "in no room"),
    ("length", "daemon/core/a.cpp", "x\n" * 400, None),
    ("length", "daemon/core/a.cpp", "x\n" * 401, "401 lines"),
    ("length", "scripts/a.lua", "x\n" * 401, "401 lines"),
    ("length", "cmake/a.cmake", "x\n" * 401, "401 lines"),
    ("length", "tests/a.py", "x\n" * 401, "401 lines"),
    ("length", "a.sh", "x\n" * 401, "401 lines"),
    ("length", "dev", "x\n" * 401, "401 lines"),
    ("length", "physics/CMakeLists.txt", "x\n" * 401, "401 lines"),
    ("licence", "physics/a.h", SPDX, None),
    ("licence", "dev", "#!/bin/sh\n# SPDX-License-Identifier: MIT\n", None),
    ("licence", "physics/a.h", "#pragma once\n", "SPDX"),
    ("licence", "scripts/a.lua", "print(1)\n", "SPDX"),
    ("licence", "CMakeLists.txt", "project(a)\n", "SPDX"),
    ("ifdef", "daemon/core/a.h", "#define X _WIN32_WINNT\n", None),
    ("ifdef", "daemon/core/a.h", "#ifdef _WIN32\n#endif\n", "_WIN32"),
    ("ifdef", "tests/a.cpp", "#if defined(__linux__)\n#endif\n", "__linux__"),
    ("format", "physics/a.cpp", "int f() {\n    return 1;\n}\n", None),
    ("format", "physics/a.cpp", "int f()\n{ return 1; }\n", "clang-format"),
    ("format", "physics/a.cpp", "int f(int* a) {\n    if (a)\n        return 1;\n    return 2;\n}\n", "clang-format"),
]

GOOD_DUMP = """
Time/Date\t\tThu Jan  1 00:00:00 1970
MajorSubsystemVersion\t10
DllCharacteristics\t00008160
\tDLL Name: KERNEL32.dll
\tvma:  Hint/Ord Member-Name Bound-To
\tf6b28\t  283  CreateFileW
"""
# (a change of the good dump, words of the problem)
DUMP_CASES = [
    (("KERNEL32.dll", "libstdc++-6.dll"), "libstdc++-6.dll"),
    (("KERNEL32.dll", "winmm.dll"), "winmm.dll"),
    (("CreateFileW", "SetLayeredWindowAttributes"), "imports SetLayeredWindowAttributes"),
    (("00008160", "00000160"), "TERMINAL_SERVER_AWARE"),
    (("00008160", "00008140"), "HIGH_ENTROPY_VA"),
    (("Version\t10", "Version\t5"), "subsystem version"),
    (("DLL Name", "No Name"), "no import table"),
]


def run(project):
    failures = []

    def expect(what, problems, words):
        right = not problems if words is None else any(words in problem for problem in problems)
        if not right:
            failures.append(f"{what}: expected {words!r}, got {problems}")

    for rule, name, content, words in CASES:
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(content, encoding="utf-8")
            if rule == "format":
                (root / ".clang-format").write_bytes((project / ".clang-format").read_bytes())
                problems = list(lint.check_format(root, project))
            else:
                problems = list(lint.CHECKS[rule](root))
            expect(f"{rule} on {name} with {content[:60]!r}", problems, words)

    expect("imports", list(lint.judge_imports("a.exe", GOOD_DUMP)), None)
    for change, words in DUMP_CASES:
        expect(f"imports with {change[1]!r}", list(lint.judge_imports("a.exe", GOOD_DUMP.replace(*change))), words)

    for failure in failures:
        print(failure)
    print(f"{len(CASES) + len(DUMP_CASES) + 1} cases, {len(failures)} failed")
    return 1 if failures else 0
