# SPDX-License-Identifier: MIT
"""A pet is thrown by real X events and flies the way the hand moved.

Usage: test_throw.py hyrax.exe

Alone on the machine: where hyrax.exe or the hand is kept waiting, all moves come as one, and that is
no throw.
"""

import desktop
import fixture
from daemon import BOX, grip, pets_at


class OnThreeMonitors(fixture.OnDesktop):
    MONITORS = desktop.THREE_MONITORS

    def test_a_pet_is_grabbed_thrown_and_flies_the_way_the_hand_moved(self):
        self.throw(reports=125)

    def test_a_pointer_that_speaks_seldom_throws_as_well(self):
        self.throw(reports=40)

    def throw(self, reports):
        daemon = self.daemon(pets_at((-600, 400)))
        (pet,) = daemon.wait_for_rest()
        self.assertEqual((pet["x"], pet["y"]), (-600, 648 - BOX[1]))
        x, y = grip(pet)
        seconds = 0.48
        steps = round(seconds * reports)
        way = [(x - 180 * i // steps, y - 240 * i // steps) for i in range(steps + 1)]
        self.desk.drag(way, seconds=seconds)
        daemon.wait_for_pets(lambda pets: pets and pets[0]["motion"] == "airborne", 10, "the throw")
        rows = daemon.rows()
        last_held = max(i for i, row in enumerate(rows) if row["motion"] == "held")
        self.assertAlmostEqual(rows[last_held]["x"], pet["x"] - 180, delta=60)
        first = rows[last_held + 1]
        # The hand moved 500 px/s upwards.
        self.assertLess(first["vy"], -300)
        # Three to four, as the hand went.
        self.assertAlmostEqual(first["vx"] / first["vy"], 0.75, delta=0.35)
        daemon.wait_for_rest()


if __name__ == "__main__":
    fixture.main("hyrax")
