// SPDX-License-Identifier: MIT
// Walks: the same at any frame rate, ended by what stands in the way.
#include "tests/core/engine_seen.h"

using namespace hyrax;

namespace {

constexpr double floor_y = 1080.0 - box.height;

// A pet at rest on the floor.
PetId resting(World& world, double x) {
    const PetId id = world.spawn({x, floor_y});
    world.run(0.5);
    REQUIRE_FALSE(world.pet(id).awake);
    return id;
}

void walk(World& world, PetId id, double x, double speed) {
    REQUIRE(world.engine.walk_to(id, x, speed).has_value());
}

}  // namespace

TEST_CASE("a walk has a constant speed, ends at its target and then costs nothing") {
    World world;
    const PetId id = resting(world, 500);
    walk(world, id, 300, 100);
    world.engine.advance(world.now);
    CHECK(world.pet(id).motion == Motion::walking);
    CHECK(world.pet(id).faces_left);
    const Ticks begin = world.now;
    for (const double t : {0.25, 1.0, 1.7}) {
        world.engine.advance(begin + from_seconds(t));
        CHECK(world.pet(id).position().x == doctest::Approx(500 - 100 * t).epsilon(1e-12));
        CHECK(world.pet(id).position().y == floor_y);
        CHECK(world.pet(id).velocity() == Vec2{-100, 0});
    }
    world.engine.advance(begin + from_seconds(2.5));
    CHECK(world.pet(id).position() == Vec2{300, floor_y});
    CHECK(world.pet(id).motion == Motion::settled);
    CHECK_FALSE(world.engine.moving());
}

TEST_CASE("with every integrator a walk arrives, and frames do not matter") {
    for (const Integrator integrator : integrators) {
        CAPTURE(static_cast<int>(integrator));
        for (const Ticks step : {frame, ticks_per_second / 7, ticks_per_second / 240}) {
            World world(EngineSettings{.integrator = integrator});
            const PetId id = resting(world, 500);
            walk(world, id, 777.25, 333);
            const Ticks begin = world.now;
            for (Ticks t = 0; t <= 2 * ticks_per_second; t += step) {
                world.engine.advance(begin + t);
            }
            CHECK(world.pet(id).position() == Vec2{777.25, floor_y});
            CHECK(world.pet(id).motion == Motion::settled);
        }
    }
}

TEST_CASE("walls and targets beyond them end a walk at the wall") {
    World world;
    const PetId id = resting(world, 100);
    walk(world, id, -5'000, 400);
    world.run(1.0);
    CHECK(world.pet(id).position() == Vec2{0, floor_y});
    CHECK(world.pet(id).motion == Motion::settled);
    walk(world, id, 1e9, 20'000);
    world.run(1.0);
    CHECK(world.pet(id).position() == Vec2{1920.0 - box.width, floor_y});
}

TEST_CASE("at the edge of its floor a pet walks on into the air") {
    World world;
    world.engine.set_arena(
        Arena({monitor({0, 0, 1000, 600}), monitor({1000, 0, 1000, 1000})}, FloorEdge::work_area)
    );
    const PetId id = world.spawn({700, 600.0 - box.height});
    world.run(0.5);
    walk(world, id, 1'500, 200);
    world.engine.take_events();
    world.run(1.6);
    CHECK(world.pet(id).motion == Motion::airborne);
    CHECK(world.pet(id).position().x > 1000);
    CHECK(world.pet(id).velocity().x > 150);
    world.run(8.0);
    CHECK(world.pet(id).position().y == 1000.0 - box.height);
    CHECK(world.count(EventKind::land) == 1);
}

TEST_CASE("who is in the air walks once it stands, from the very moment on, at any frame rate") {
    std::vector<Vec2> ends;
    for (const Ticks step : {frame, ticks_per_second / 50, ticks_per_second / 240}) {
        World world;
        const PetId id = world.spawn({500, 300}, {40, 0});
        walk(world, id, 1'600, 80);
        Ticks t = 0;
        while (t < 5 * ticks_per_second) {
            world.engine.advance(t);
            t += step;
        }
        world.engine.advance(5 * ticks_per_second);
        CHECK(world.pet(id).motion == Motion::walking);
        ends.push_back(world.pet(id).position());
    }
    CHECK(ends[1].x == doctest::Approx(ends[0].x).epsilon(1e-9));
    CHECK(ends[2].x == doctest::Approx(ends[0].x).epsilon(1e-9));
    CHECK(ends[0].x > 520);
}

TEST_CASE("flings, hands, stops and resets end a walk; another walk replaces it without a halt") {
    World world;
    const PetId id = resting(world, 500);
    const auto ends = [&](auto verb) {
        walk(world, id, 1'500, 100);
        world.run(0.2);
        REQUIRE(world.pet(id).motion == Motion::walking);
        verb();
        CHECK_FALSE(world.pet(id).walk.has_value());
        // At once, not with the next frame.
        CHECK(world.pet(id).motion != Motion::walking);
        world.run(0.1);
        CHECK(world.pet(id).motion != Motion::walking);
        world.run(9.0);
        CHECK(world.pet(id).motion == Motion::settled);
    };
    ends([&] { REQUIRE(world.engine.fling(id, {0, -500})); });
    ends([&] { REQUIRE(world.engine.stop(id)); });
    ends([&] { REQUIRE(world.engine.reset(id)); });
    ends([&] { REQUIRE(world.engine.move_to(id, {700, 200})); });
    ends([&] {
        REQUIRE(world.engine.grab(id, world.now));
        REQUIRE(world.engine.let_go(id, world.now + frame, 0.0));
    });

    const double from = world.pet(id).position().x;
    walk(world, id, from + 900, 60);
    for (int i = 0; i < 60; ++i) {
        world.engine.advance(world.now);
        world.now += frame;
        walk(world, id, from + 900, 60);
    }
    CHECK(world.pet(id).position().x == doctest::Approx(from + 59).epsilon(1e-6));
}

TEST_CASE("a walk goes on after a change of the law, of the screens and of the scale") {
    World world;
    const PetId id = resting(world, 200);
    walk(world, id, 1'200, 200);
    world.run(0.5);
    REQUIRE(world.engine.configure(EngineSettings{.physics = {.gravity = 900}}));
    world.run(0.5);
    CHECK(world.pet(id).motion == Motion::walking);
    world.engine.set_arena(one_monitor({0, 0, 1920, 900}));
    world.run(0.5);
    CHECK(world.pet(id).motion == Motion::walking);
    REQUIRE(world.engine.set_scale(id, 2.0));
    world.run(20.0);
    CHECK(world.pet(id).position() == Vec2{1'200, 900.0 - 2 * box.height});
}

TEST_CASE("hostile walks, plays and words") {
    World world;
    const PetId id = resting(world, 200);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(world.engine.walk_to(id, nan, 100));
    CHECK_FALSE(world.engine.walk_to(id, 100, nan));
    CHECK_FALSE(world.engine.walk_to(id, 100, 0));
    CHECK_FALSE(world.engine.walk_to(id, 100, -5));
    CHECK_FALSE(world.engine.walk_to(PetId{9, 9}, 100, 5));
    CHECK_FALSE(world.engine.play(id, {.animation = "x", .fps = nan}));
    CHECK_FALSE(world.engine.play(id, {.animation = "x", .fps = 1e9}));
    CHECK_FALSE(world.engine.say(id, "x", nan));
    CHECK_FALSE(world.engine.face(PetId{}, true));
    CHECK_FALSE(world.engine.moving());
    walk(world, id, -1e300, 1e300);
    world.run(1.0);
    CHECK(world.pet(id).position() == Vec2{0, floor_y});
    walk(world, id, 0, 100);
    world.run(0.1);
    CHECK_FALSE(world.engine.moving());
}
