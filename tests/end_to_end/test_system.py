# SPDX-License-Identifier: MIT
"""What scripts see and ask of the system: hotkeys, the pointer, windows, notices, the end.

Usage: test_system.py hyrax.exe ledge_probe.exe
"""

import json
import sys
import time
import unittest
from pathlib import Path

import desktop
from daemon import Daemon

EXE = PROBE = None

SCRIPT = """
local function place()
    local x, y = hyrax.cursor()
    hyrax.spawn{ x = x, y = y }
end
local key
key = hyrax.hotkey("ctrl+alt+h", "Here", place)
hyrax.hotkey("ctrl+alt+x", "No more", function() key:cancel() print("cancelled") end)
hyrax.hotkey("ctrl+alt+w", "Windows", function()
    for _, w in ipairs(hyrax.windows()) do
        print(string.format("window %d %d %d %d", w.x, w.y, w.w, w.h))
    end
    print("all")
end)
hyrax.hotkey("ctrl+alt+n", "Notice", function() hyrax.notify("It rains.") end)
hyrax.on("unload", function(why) hyrax.store.set("why", why) end)
print("ready")
"""


class System(unittest.TestCase):
    def test_hotkeys_pointer_windows_notices_and_the_end(self):
        with desktop.VirtualDesktop() as desk:
            daemon = Daemon(desk, EXE, {"pets": {"start": []}}, scripts={"keys.lua": SCRIPT})
            daemon.wait_for_log("keys.lua: ready")
            # Wine hears of keys only through a window that the keyboard is given to.
            desk.start(PROBE, "show", 400, 300, 300, 200).wait_for_text("^ready$", 30)
            desk.click(500, 400)
            time.sleep(0.5)

            desk.key("ctrl+alt+w")
            daemon.wait_for_log("keys.lua: window 400 300 300 200(.|\n)*keys.lua: all")
            desk.key("ctrl+alt+n")
            daemon.wait_for_log("notice of keys.lua: It rains.$")
            desk.move(520, 410)
            desk.key("ctrl+alt+h")
            (pet,) = daemon.wait_for_pets(lambda pets: len(pets) == 1, 10, "the pet at the pointer")
            self.assertAlmostEqual(pet["x"], 520, delta=2)

            desk.key("ctrl+alt+x")
            daemon.wait_for_log("keys.lua: cancelled")
            desk.key("ctrl+alt+h")
            time.sleep(1.0)
            self.assertEqual(len(daemon.pets()), 1)

            # What was taken is free again for the text that follows.
            text = SCRIPT.replace('print("ready")', 'print("again")')
            (daemon.profile / "scripts" / "keys.lua").write_text(text)
            daemon.wait_for_log("keys.lua: again")
            time.sleep(0.5)
            desk.key("ctrl+alt+h")
            daemon.wait_for_pets(lambda pets: len(pets) == 2, 10, "the second pet")
            self.assertNotIn("has it", daemon.log_text())

            self.assertEqual(daemon.second_start("--quit"), 0)
            self.assertEqual(daemon.program.wait(10), 0)
            kept = json.loads((daemon.profile / "store" / "keys.lua.json").read_text())
            self.assertEqual(kept, {"why": "exit"})


if __name__ == "__main__":
    EXE, PROBE = (Path(argument).resolve() for argument in sys.argv[1:3])
    del sys.argv[1:3]
    unittest.main(verbosity=2)
