// SPDX-License-Identifier: MIT
// Pets in the hand.
#include "tests/core/engine_world.h"

#include <cmath>

using namespace hyrax;

namespace {

constexpr Ticks mouse_interval = 8 * ticks_per_ms;  // 125 samples a second.

}  // namespace

TEST_CASE("a held pet follows the hand alone, and is thrown with the hand's velocity") {
    World world;
    const PetId id = world.spawn({300.0, 200.0});
    CHECK(world.engine.grab(id, 0));
    CHECK_FALSE(world.engine.moving());
    world.run(1.0);
    CHECK(world.pet(id).position() == Vec2{300.0, 200.0});

    for (int i = 1; i <= 50; ++i) {
        CHECK(world.engine.carry(id, {300.0 - 8.0 * i, 200.0}, i * mouse_interval));
    }
    CHECK(world.engine.advance_held(50 * mouse_interval));
    CHECK(std::fabs(world.pet(id).position().x - -100.0) < 1000.0 / 60.0);

    CHECK(world.engine.fling(id, {1.0, 1.0}));
    CHECK(world.engine.reset(id));
    CHECK(world.engine.move_to(id, {0.0, 0.0}));
    CHECK(world.pet(id).motion == Motion::held);

    CHECK(world.engine.let_go(id, 50 * mouse_interval, 5000.0));
    CHECK(world.pet(id).velocity().x == doctest::Approx(-1000.0).epsilon(0.01));
    CHECK(world.pet(id).motion == Motion::airborne);
    CHECK(world.count(EventKind::throw_pet) == 1);
}

TEST_CASE("a held pet comes to hang still, and then costs nothing") {
    World world;
    const PetId id = world.spawn({300.0, 200.0});
    CHECK(world.engine.grab(id, 0));
    CHECK(world.engine.carry(id, {500.0, 400.0}, mouse_interval));
    CHECK(world.engine.advance_held(2 * mouse_interval));
    CHECK_FALSE(world.engine.advance_held(ticks_per_second));
    CHECK(world.pet(id).position().x == doctest::Approx(500.0));
    CHECK(world.engine.let_go(id, 2 * ticks_per_second, 5000.0));
    CHECK(std::fabs(world.pet(id).velocity().x) < 1.0);
}

TEST_CASE("a flying pet is caught without a leap") {
    World world;
    const PetId id = world.spawn({300.0, 200.0}, {1500.0, 0.0});
    world.run(0.1);
    const Vec2 before = world.pet(id).position();
    CHECK(world.engine.grab(id, 0));
    for (Ticks time = 0; time < ticks_per_second / 2; time += ticks_per_ms) {
        world.engine.advance_held(time);
        REQUIRE(std::fabs(world.pet(id).position().x - before.x) < 10.0);
    }
    CHECK(world.pet(id).position().x == doctest::Approx(before.x));
}

TEST_CASE("a throw is shortened to the limit and keeps its direction") {
    World world;
    const PetId id = world.spawn({300.0, 200.0});
    CHECK(world.engine.grab(id, 0));
    for (int i = 1; i <= 20; ++i) {
        CHECK(world.engine.carry(id, {300.0 + 30.0 * i, 200.0 + 40.0 * i}, i * mouse_interval));
    }
    CHECK(world.engine.let_go(id, 20 * mouse_interval, 1000.0));
    CHECK(world.pet(id).velocity().x == doctest::Approx(600.0).epsilon(0.01));
    CHECK(world.pet(id).velocity().y == doctest::Approx(800.0).epsilon(0.01));
}

TEST_CASE("a pet that is let go outside the arena comes back to its edge") {
    World world;
    const PetId id = world.spawn({300.0, 200.0});
    CHECK(world.engine.grab(id, 0));
    CHECK(world.engine.carry(id, {-700.0, 2000.0}, ticks_per_second));
    CHECK(world.engine.let_go(id, 3 * ticks_per_second, 0.0));
    CHECK(world.pet(id).position() == Vec2{0.0, 1080.0 - box.height});
    CHECK(world.pet(id).velocity() == Vec2{});
}

TEST_CASE("a pet that is removed out of the hand is gone") {
    World world;
    const PetId id = world.spawn({300.0, 200.0});
    CHECK(world.engine.grab(id, 0));
    CHECK(world.engine.remove(id));
    CHECK_FALSE(world.engine.advance_held(mouse_interval));
    CHECK_FALSE(world.engine.carry(id, {1.0, 1.0}, mouse_interval));
}
