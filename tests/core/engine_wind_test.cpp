// SPDX-License-Identifier: MIT
// Wind that comes and goes while pets fly.
#include "tests/core/engine_world.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace hyrax;

TEST_CASE("wind: it changes the integrator while it blows, and no longer") {
    World world;
    CHECK(world.engine.integrator() == Integrator::event_driven);
    REQUIRE(world.engine.set_wind({3000.0, 0.0}));
    CHECK(world.engine.integrator() == Integrator::rk45);
    REQUIRE(world.engine.configure(world.engine.settings()));
    CHECK(world.engine.integrator() == Integrator::rk45);
    REQUIRE(world.engine.set_wind({}));
    CHECK(world.engine.integrator() == Integrator::event_driven);
    CHECK_FALSE(world.engine.set_wind({std::numeric_limits<double>::quiet_NaN(), 0.0}));
}

TEST_CASE("wind: a flight goes on from where it is, and is pulled along") {
    World calm;
    World windy;
    const PetId a = calm.spawn({900.0, 0.0}, {200.0, -100.0});
    const PetId b = windy.spawn({900.0, 0.0}, {200.0, -100.0});
    calm.run(0.3);
    windy.run(0.3);
    REQUIRE(same(calm.pet(a), windy.pet(b)));
    REQUIRE(windy.engine.set_wind({3000.0, 0.0}));
    CHECK(same(calm.pet(a), windy.pet(b)));
    Vec2 before = windy.pet(b).position();
    for (int i = 0; i < 12; ++i) {
        calm.run(0.016);
        windy.run(0.016);
        const Vec2 now = windy.pet(b).position();
        // No frame stands still and none jumps: the speed is 200 to 400 px/s.
        CHECK(now.x - before.x > 190.0 / 60.0);
        CHECK(now.x - before.x < 400.0 / 60.0);
        before = now;
    }
    // Drag is 0.06 a second: 3000 px/s of air add about 180 px/s each second.
    CHECK(
        windy.pet(b).velocity().x - calm.pet(a).velocity().x == doctest::Approx(36.0).epsilon(0.05)
    );
    CHECK(windy.pet(b).velocity().y == doctest::Approx(calm.pet(a).velocity().y).epsilon(1e-4));

    const Vec2 velocity = windy.pet(b).velocity();
    REQUIRE(windy.engine.set_wind({}));
    CHECK(windy.pet(b).velocity() == velocity);
    windy.run(10.0);
    CHECK_FALSE(windy.engine.moving());
}

TEST_CASE("wind: who is blown against a wall leans there, and does not bounce without end") {
    World world;
    const PetId id = world.spawn({1810.0, 0.0});
    REQUIRE(world.engine.set_wind({9000.0, 0.0}));
    world.run(1.1);
    CHECK(world.pet(id).motion == Motion::airborne);
    CHECK(world.pet(id).position().x == 1820.0);
    CHECK(world.pet(id).velocity().x == 0.0);
    CHECK(world.pet(id).velocity().y > 500.0);
    CHECK(world.engine.report().contacts < 20);
    REQUIRE(world.engine.set_wind({-9000.0, 0.0}));
    world.run(0.2);
    CHECK(world.pet(id).position().x < 1819.0);
}

TEST_CASE("wind: who lies on the ground is left alone, and so is who was just spawned") {
    World world;
    const PetId id = world.spawn({900.0, 900.0});
    world.run(8.0);
    REQUIRE_FALSE(world.engine.moving());
    REQUIRE(world.engine.set_wind({9000.0, 0.0}));
    CHECK_FALSE(world.engine.moving());
    const Vec2 resting = world.pet(id).position();
    const PetId fresh = world.spawn({300.0, 10.0});
    REQUIRE(world.engine.set_wind({8000.0, 0.0}));
    world.engine.advance(world.now);
    CHECK(world.pet(fresh).position() == Vec2{300.0, 10.0});
    world.run(1.0);
    CHECK(world.pet(fresh).position().x > 400.0);
    CHECK(world.pet(id).position() == resting);
}
