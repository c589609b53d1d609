# SPDX-License-Identifier: MIT
"""What scripts see and ask of the system: hotkeys, the pointer, windows, notices, the end.

Usage: test_system.py hyrax.exe ledge_probe.exe
"""

import json
import time

import desktop
import fixture
from daemon import pets_at

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


class System(fixture.OnDesktop):
    def test_hotkeys_pointer_windows_notices_and_the_end(self):
        daemon = self.daemon(pets_at(), scripts={"keys.lua": SCRIPT})
        daemon.wait_for_log("keys.lua: ready")
        # Wine hears of keys only through a window that the keyboard is given to.
        self.ready_probe("show", 400, 300, 300, 200)
        self.desk.click(500, 400)
        time.sleep(0.5)

        self.desk.key("ctrl+alt+w")
        daemon.wait_for_log("keys.lua: window 400 300 300 200(.|\n)*keys.lua: all")
        self.desk.key("ctrl+alt+n")
        daemon.wait_for_log("notice of keys.lua: It rains.$")
        self.desk.move(520, 410)
        self.desk.key("ctrl+alt+h")
        (pet,) = daemon.wait_for_pets(lambda pets: len(pets) == 1, 10, "the pet at the pointer")
        self.assertAlmostEqual(pet["x"], 520, delta=2)

        self.desk.key("ctrl+alt+x")
        daemon.wait_for_log("keys.lua: cancelled")
        self.desk.key("ctrl+alt+h")
        time.sleep(1.0)
        self.assertEqual(len(daemon.pets()), 1)

        # What was taken is free again for the text that follows.
        text = SCRIPT.replace('print("ready")', 'print("again")')
        (daemon.profile / "scripts" / "keys.lua").write_text(text)
        daemon.wait_for_log("keys.lua: again")
        time.sleep(0.5)
        self.desk.key("ctrl+alt+h")
        daemon.wait_for_pets(lambda pets: len(pets) == 2, 10, "the second pet")
        self.assertNotIn("has it", daemon.log_text())

        self.quit(daemon)
        kept = json.loads((daemon.profile / "store" / "keys.lua.json").read_text())
        self.assertEqual(kept, {"why": "exit"})

    def test_the_users_own_hotkeys(self):
        daemon = self.daemon({"hotkeys": {"hide": "ctrl+alt+h"}, **pets_at((300, 300))}, scripts={"keys.lua": SCRIPT})
        daemon.wait_for_log("keys.lua: hotkey ctrl\\+alt\\+h: /hotkeys/hide has it already")
        daemon.wait_for_rest()
        self.ready_probe("show", 600, 300, 300, 200)
        self.desk.click(700, 400)
        time.sleep(0.5)
        self.desk.key("ctrl+alt+h")
        desktop.wait_for(lambda: not self.panes(), 10, "the pets to go")
        self.desk.key("ctrl+alt+h")
        desktop.wait_for(self.panes, 10, "the pets to come back")
        self.quit(daemon)


if __name__ == "__main__":
    fixture.main("hyrax", "probe")
