// SPDX-License-Identifier: MIT
// Monitors that come and go under bodies in flight: the space is switched, and whoever is affected
// is launched anew from where it is, as the daemon does.
#include "tests/physics/layouts.h"
#include "tests/physics/random_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

using namespace hyrax;
using namespace hyrax::test;

namespace {

const std::vector<Rect>& rooms_of(std::size_t index) {
    static const std::vector<Layout> all = layouts();
    return all[index % all.size()].rooms;
}

// A body on a desktop that changes.
struct Pet {
    Law law;
    Size box;
    FreeSpace space;
    Trajectory body;

    BodyState at(Ticks now) {
        body.advance(now, law, space, [](const TrajectoryEvent&) {});
        return body.at(now, law, space);
    }
    // What the body moved, and where it then is. It keeps what velocity does not point back in.
    Vec2 move_to(Ticks now, FreeSpace next) {
        const BodyState before = at(now);
        const Vec2 place = before.position - space.overhang() + next.overhang();
        const Vec2 moved = next.nearest(place) - place;
        Vec2 velocity = before.velocity;
        velocity.x = moved.x * velocity.x < 0.0 ? 0.0 : velocity.x;
        velocity.y = moved.y * velocity.y < 0.0 ? 0.0 : velocity.y;
        space = std::move(next);
        body.launch(now, place, velocity, law, space);
        return moved;
    }
};

}  // namespace

TEST_CASE("whatever monitors come and go, nobody is lost and nobody is moved who need not") {
    int changes = 0;
    int moved = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        std::vector<Rect> rooms = rooms_of(random.below(100));
        Pet pet{random_law(random), {random.whole(16, 300), random.whole(16, 300)}, {}, {}};
        pet.space = FreeSpace::among(rooms, pet.box);
        Ticks now = random.ticks(1000 * ticks_per_second);
        pet.body.launch(
            now,
            random_place(random, pet.space),
            random_velocity(random, 10.0, 5000.0),
            pet.law,
            pet.space
        );
        for (int change = 0; change < 20; ++change) {
            now += random.ticks(ticks_per_second / 2);
            rooms = rooms_of(random.below(100));
            const BodyState before = pet.at(now);
            const Vec2 overhang = pet.space.overhang();
            const Vec2 by = pet.move_to(now, FreeSpace::among(rooms, pet.box));
            const BodyState after = pet.at(now);
            ++changes;
            moved += by == Vec2{} ? 0 : 1;
            CHECK(pet.space.contains(after.position));
            const Vec2 place = before.position - overhang + pet.space.overhang();
            if (pet.space.contains(place)) {
                CHECK(after.position == place);
            }
            for (int read = 0; read < 20; ++read) {
                now += random.ticks(ticks_per_second / 30);
                CHECK(depth_inside(pet.space, pet.at(now).position) <= 1e-9);
            }
        }
    }
    MESSAGE(changes, " changes, ", moved, " moves");
    CHECK(moved > 500);
}

TEST_CASE("a change far away is not felt: whoever is let go where it is goes on as before") {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const std::vector<Rect> rooms{{0, 0, 1920, 1040}, {1920, -300, 1280, 1024}};
        std::vector<Rect> more = rooms;
        // It touches a corner alone: no way leads there.
        more.push_back({3200, 724, 1920, 1080});
        const Size box{128, 96};
        Scene scene{random_law(random), FreeSpace::among(rooms, box), {}, {}};
        scene.position = random_place(random, scene.space);
        scene.velocity = random_velocity(random, 10.0, 3000.0);
        Run undisturbed(scene);
        Pet pet{scene.law, box, scene.space, {}};
        pet.body.launch(0, scene.position, scene.velocity, pet.law, pet.space);
        for (int change = 0; change < 8; ++change) {
            const Ticks now = (change + 1) * 400'000'000LL;
            const BodyState expected = undisturbed.at(now);
            const BodyState before = pet.at(now);
            CHECK(
                pet.move_to(now, FreeSpace::among(change % 2 == 0 ? more : rooms, box)) == Vec2{}
            );
            const BodyState after = pet.at(now);
            CHECK(same_bits(after, before));
            const double miss = distance(after.position, expected.position);
            worst = std::max(worst, miss);
            // A new launch is rounded anew, and bounces magnify that; what is felt is a thousandth.
            CHECK(miss <= 1e-8);
            CHECK(after.mode == expected.mode);
        }
    }
    MESSAGE("worst ", worst, " px");
}

TEST_CASE("a resting body rests on, falls when its floor goes, and is lifted by one that rises") {
    const Size box{100, 100};
    const Law law = law_from({});
    Pet pet{law, box, FreeSpace::among({{0, 0, 1000, 1000}}, box), {}};
    pet.body.launch(0, {300.0, 900.0}, {}, law, pet.space);
    CHECK(pet.at(0).mode == Mode::rest);

    const Ticks second = ticks_per_second;
    CHECK(pet.move_to(second, FreeSpace::among({{0, 0, 1400, 1000}}, box)) == Vec2{});
    CHECK(pet.body.next_event() == never);

    pet.move_to(2 * second, FreeSpace::among({{0, 0, 1000, 1300}}, box));
    CHECK(pet.at(2 * second).mode == Mode::air);
    double highest = 900.0;
    for (Ticks now = 2 * second; now < 10 * second; now += ticks_per_ms) {
        highest = std::min(highest, pet.at(now).position.y);
    }
    CHECK(highest == 900.0);
    CHECK(pet.at(10 * second).position == Vec2{300.0, 1200.0});
    CHECK(pet.at(10 * second).mode == Mode::rest);

    CHECK(
        pet.move_to(11 * second, FreeSpace::among({{0, 0, 1000, 800}}, box)) == Vec2{0.0, -500.0}
    );
    CHECK(pet.at(11 * second).position == Vec2{300.0, 700.0});
    CHECK(pet.at(11 * second).mode == Mode::rest);
}

TEST_CASE("a floor that rises under a rising body leaves it its speed") {
    const Size box{100, 100};
    Pet pet{law_from({}), box, FreeSpace::among({{0, 0, 1000, 1000}}, box), {}};
    pet.body.launch(0, {300.0, 850.0}, {200.0, -900.0}, pet.law, pet.space);
    const Ticks now = ticks_per_second / 60;
    const Vec2 before = pet.at(now).velocity;
    CHECK(pet.move_to(now, FreeSpace::among({{0, 0, 1000, 800}}, box)).y < 0.0);
    CHECK(pet.at(now).position.y == 700.0);
    CHECK(pet.at(now).velocity == before);
}
