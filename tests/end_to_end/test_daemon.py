# SPDX-License-Identifier: MIT
"""hyrax.exe under Wine with real X events: what a user does, and what must come of it.

Usage: test_daemon.py hyrax.exe window_probe.exe post_message.exe
"""

import shutil
import time

import desktop
import fixture
from daemon import BOX, FLOATING, FUR, around, grip, pets_at
from fixture import WALLPAPER

# A place in the sprite's box that is air in every pose.
AIR = (3, 3)


class OnThreeMonitors(fixture.OnDesktop):
    MONITORS = desktop.THREE_MONITORS

    def test_a_pet_is_carried_to_another_monitor(self):
        daemon = self.daemon(pets_at((-150, 400)))
        (pet,) = daemon.wait_for_rest()
        x, y = grip(pet)
        self.desk.carry([(x + (300 - x) * i / 20, y + (300 - y) * i / 20) for i in range(21)])
        (pet,) = daemon.wait_for_rest()
        self.assertEqual(pet["y"], 720 - BOX[1])
        self.assertGreater(pet["x"], 0)

    def test_a_click_beside_the_pet_reaches_the_window_below(self):
        # First the window below: without a window manager, X puts the latest one on top.
        probe = self.ready_probe(400, 500, 300, 220)
        daemon = self.daemon(pets_at((500, 600)))
        (pet,) = daemon.wait_for_rest()
        for beside in ((pet["x"] + AIR[0], pet["y"] + AIR[1]), (pet["x"] - 60, pet["y"] + 40)):
            self.desk.click(*beside)
            probe.wait_for_text(f"^up {int(beside[0])} {int(beside[1])}$")
        heard = probe.text().count("down")
        self.desk.click(*grip(pet), hold=0.5)
        daemon.wait_for_grab()
        self.assertEqual(probe.text().count("down"), heard)

    def test_clicks_go_through_pets_where_that_is_wished(self):
        probe = self.ready_probe(400, 500, 300, 220)
        daemon = self.daemon({"overlay": {"click_through": True}, **pets_at((500, 600))})
        (pet,) = daemon.wait_for_rest()
        x, y = grip(pet)
        self.desk.click(x, y)
        probe.wait_for_text(f"^up {int(x)} {int(y)}$")
        self.open_menu()
        self.desk.key("k")
        daemon.wait_for_state("click_through", False)
        heard = probe.text().count("down")
        self.desk.click(x, y, hold=0.5)
        daemon.wait_for_grab()
        self.assertEqual(probe.text().count("down"), heard)
        (pet,) = daemon.wait_for_rest()
        self.assertEqual(daemon.second_start("--click-through", "on"), 0)
        daemon.wait_for_state("click_through", None)  # as the config has it
        self.desk.click(*grip(pet))
        desktop.wait_for(lambda: probe.text().count("down") > heard, 10, "the click to go through again")

    def test_a_kind_that_comes_with_its_script_is_there_in_a_moment(self):
        daemon = self.daemon({**FLOATING, **pets_at((100, 300), vx=60)})
        daemon.wait_for_pets(lambda pets: len(pets) == 1, 20)
        shipped = fixture.programs["hyrax"].parent / "config" / "sprites" / "hyrax"
        shutil.copytree(shipped, daemon.profile / "sprites" / "marmot")
        (daemon.profile / "scripts" / "marmot.lua").write_text('hyrax.spawn{ kind = "marmot", x = 500, y = 100 }')
        daemon.wait_for_pets(lambda pets: len(pets) == 2, 10, "the marmot")
        self.quit(daemon)

    def test_the_picture_stands_where_the_trace_says_on_every_monitor(self):
        before = self.desk.screenshot()
        daemon = self.daemon(pets_at((100, 500), (-900, 300), (1700, 400)))
        pets = daemon.wait_for_rest(3)
        picture = self.desk.screenshot()
        for pet in pets:
            x, y = int(pet["x"]), int(pet["y"])
            self.assertNotEqual(picture[x + FUR[0], y + FUR[1]], WALLPAPER)
            self.assertEqual(picture[x + AIR[0], y + AIR[1]], WALLPAPER)
            _, top, width, height = picture.crop(*around(pet)).changed_box(before.crop(*around(pet)))
            # The feet stand on the box's bottom.
            self.assertAlmostEqual(top + height, y + BOX[1], delta=1)
            self.assertGreater(width, 80)

    def test_editing_gravity_changes_the_next_second(self):
        config = {"physics": {"gravity": 0, "air_drag": 1}, **pets_at((300, 300), vx=40, vy=0)}
        daemon = self.daemon(config)
        daemon.wait_for_pets(lambda pets: pets and pets[0]["x"] > 310, 20, "the pet to drift")
        self.assertEqual(daemon.pets()[0]["y"], 300)
        config["physics"]["gravity"] = 800
        daemon.write_config(config)
        daemon.wait_for_pets(lambda pets: pets[0]["vy"] > 100, 10, "the pet to fall")
        falling = [row for row in daemon.rows() if row["vy"] > 0]
        self.assertLess(falling[0]["vy"], 60)
        # A broken file keeps the pet falling by the last good law.
        daemon.write_config('{"physics": {"gravity": ')
        daemon.wait_for_log(r"config\.json:1:\d+: ")
        daemon.wait_for_rest()

    def test_a_second_start_hands_its_arguments_over(self):
        daemon = self.daemon(pets_at((300, 300)))
        daemon.wait_for_pets(lambda pets: len(pets) == 1)
        begin = time.monotonic()
        self.assertEqual(daemon.second_start("--spawn", "2"), 0)
        self.assertLess(time.monotonic() - begin, 10)
        daemon.wait_for_pets(lambda pets: len(pets) == 3, 10, "three pets")
        self.assertEqual(daemon.second_start(), 0)
        daemon.wait_for_pets(lambda pets: len(pets) == 4, 10, "four pets")
        self.quit(daemon)

    def test_the_tray_menu_spawns_pauses_and_quits(self):
        daemon = self.daemon(pets_at((300, 300)))
        daemon.wait_for_rest()
        self.open_menu()
        self.desk.key("s", "h")
        daemon.wait_for_pets(lambda pets: len(pets) == 2, 10, "the second pet")
        daemon.wait_for_rest(2)

        self.open_menu()
        self.desk.key("f")
        daemon.wait_for_pets(lambda pets: all(pet["motion"] == "airborne" for pet in pets), 10, "all to fly")
        self.open_menu()
        self.desk.key("p")
        time.sleep(1.0)
        self.assert_still(daemon)
        self.open_menu()
        self.desk.key("p")
        daemon.wait_for_rest(2)

        self.open_menu()
        self.desk.key("q")
        self.assertEqual(daemon.program.wait(10), 0)
        self.assertNotIn("hyrax.exe", " ".join(line for _, line in self.desk.processes()))
        self.assertIn("bye", daemon.log_text())

    def test_the_tray_menu_resets_opens_the_config_and_tells_what_is_wrong(self):
        daemon = self.daemon(pets_at((300, 300), vx=200))
        (rested,) = daemon.wait_for_rest()
        self.assertGreater(rested["x"], 310)
        usual = self.open_menu()
        self.desk.key("r")
        daemon.wait_for_pets(lambda pets: (pets[0]["x"], pets[0]["vx"]) == (300, 0), 10, "the pet to fall straight down")
        (again,) = daemon.wait_for_rest()
        self.assertEqual(again["x"], 300)

        daemon.write_config('{"physics": {"gravity": "heavy"}}')
        daemon.wait_for_log(r"config\.json:1:\d+: ")
        longer = self.open_menu()
        self.assertGreater(longer.height, usual.height)
        self.assertGreater(longer.width, usual.width)
        self.desk.key("c", "r")
        self.open_menu()
        self.desk.key("o", "c")
        (editor,) = desktop.wait_for(lambda: self.desk.windows("config.json"), 30, "the editor with config.json")
        self.assertGreater(editor.width, 100)
        self.quit(daemon)

    def test_pets_fly_on_while_the_menu_is_open(self):
        daemon = self.daemon({**FLOATING, **pets_at((100, 300), vx=60)})
        daemon.wait_for_pets(lambda pets: pets and pets[0]["x"] > 110, 20, "the pet to drift")
        menu = self.open_menu()
        opened = daemon.pets()[0]
        time.sleep(2.0)
        later = daemon.pets()[0]
        self.assertTrue(self.desk.is_viewable(menu))
        self.assertAlmostEqual(later["x"] - opened["x"], 60 * (later["time"] - opened["time"]), delta=3)
        self.assertGreater(later["x"] - opened["x"], 60)
        self.desk.key("Escape")
        desktop.wait_for(lambda: not self.desk.is_viewable(menu), 10, "the menu to close")
        daemon.wait_for_pets(lambda pets: pets[0]["x"] > later["x"] + 30, 10, "the pet to drift on")

    def test_a_script_spawns_and_throws(self):
        script = "local p = hyrax.spawn{ x = 400, y = 300 } hyrax.after(0.5, function() p:fling(-300, -400) end)"
        daemon = self.daemon(pets_at(), scripts={"throw.lua": script})
        daemon.wait_for_pets(lambda pets: pets and pets[0]["vx"] < -100, 20, "the fling")

    def test_nothing_wakes_the_daemon_when_all_rest(self):
        daemon = self.daemon(pets_at((300, 600), drowsy_after=0))
        daemon.wait_for_rest()
        time.sleep(22)  # six breaths, then it lies still
        frames = len(daemon.rows())
        post = fixture.programs["post"]
        counted = daemon.statistics(post)
        time.sleep(0.5)
        before = daemon.program.wakeups()
        time.sleep(10)
        self.assertLessEqual(daemon.program.woken_since(before), 2)
        self.assertEqual(len(daemon.rows()), frames)
        later = daemon.statistics(post)
        for key in ("frames", "presents", "presented_bytes", "timer_wakeups"):
            self.assertEqual(later[key], counted[key], key)
        self.assertGreater(later["presents"], 10)

    def test_bad_profiles_do_not_stop_the_daemon(self):
        for config in ("", '{"physics": {"restitution": 7}}', "[" * 10_000, "\udcff".encode(errors="surrogateescape").decode("latin-1")):
            with self.subTest(config=config[:30]):
                daemon = self.daemon(config)
                daemon.wait_for_log(r"config\.json:1:\d+: |config\.json: ")
                daemon.wait_for_pets(lambda pets: len(pets) >= 1, 20, "the default pet")
                self.quit(daemon)


if __name__ == "__main__":
    fixture.main("hyrax", "probe", "post")
