// SPDX-License-Identifier: MIT
// Pets and monitors, and what the engine takes over from outside.
#include "tests/core/engine_world.h"

#include <initializer_list>
#include <limits>

using namespace hyrax;

TEST_CASE("pets on a monitor that goes away move to the nearest one and stay alive") {
    World world;
    world.engine.set_arena(Arena(
        {monitor({0, 0, 1920, 1080}), monitor({-1600, -200, 1600, 900})}, FloorEdge::work_area
    ));
    const PetId left = world.spawn({-1200.0, 100.0}, {50.0, 0.0});
    const PetId right = world.spawn({600.0, 100.0}, {50.0, 0.0});
    CHECK(world.pet(left).home == Rect{-1600, -200, 1600, 900});
    world.engine.set_arena(Arena({monitor({0, 0, 1920, 1080})}, FloorEdge::work_area));
    CHECK(world.pet(left).position() == Vec2{0.0, 100.0});
    CHECK(world.pet(left).velocity() == Vec2{});
    CHECK(world.pet(right).position() == Vec2{600.0, 100.0});
    CHECK(world.pet(right).velocity() == Vec2{50.0, 0.0});
}

TEST_CASE("pets on a monitor at negative coordinates live by the same law") {
    World world({.integrator = Integrator::semi_implicit_euler});
    world.engine.set_arena(Arena({monitor({-1600, -200, 1600, 900})}, FloorEdge::work_area));
    const PetId id = world.spawn({-1500.0, -200.0}, {300.0, 0.0});
    physics expected(100.0, 0.0, 300.0, 0.0);
    world.engine.advance(0);
    for (int i = 1; i < 200; ++i) {
        world.engine.advance(i * frame);
        expected.update(to_seconds(frame), 1600, 900, box.width, box.height);
    }
    CHECK(world.pet(id).position() == Vec2{expected.x() - 1600.0, expected.y() - 200.0});
}

TEST_CASE("a pet flies from monitor to monitor without meeting anything") {
    World world;
    world.engine.set_arena(
        Arena({monitor({0, 0, 1000, 800}), monitor({1000, 0, 1000, 800})}, FloorEdge::work_area)
    );
    const PetId id = world.spawn({700.0, 300.0}, {800.0, -300.0});
    world.engine.take_events();
    world.run(0.5);
    CHECK(world.pet(id).position().x > 1000.0);
    CHECK(world.count(EventKind::bounce) == 0);
}

TEST_CASE("a sprite wider than its monitor is pinned in the middle and does not flicker") {
    World world;
    world.engine.set_arena(Arena({monitor({0, 0, 60, 1080})}, FloorEdge::work_area));
    const PetId id = world.spawn({10.0, 0.0}, {500.0, 0.0});
    for (int i = 0; i < 600; ++i) {
        world.engine.advance(i * frame);
        REQUIRE(world.pet(id).position().x == -20.0);
    }
    CHECK_FALSE(world.engine.moving());
}

TEST_CASE("monitors that change move nobody who need not") {
    World world;
    const Arena wide(
        {monitor({0, 0, 1000, 800}), monitor({1000, 0, 1000, 800})}, FloorEdge::screen
    );
    world.engine.set_arena(wide);
    const PetId resting = world.spawn({100.0, 700.0});
    world.run(3.0);
    REQUIRE_FALSE(world.engine.moving());
    const PetId rising = world.spawn({500.0, 600.0}, {10.0, -900.0});
    world.engine.advance(world.now);

    // The floor comes up by 100 px: a resting pet is carried, a rising one goes on rising.
    world.engine.set_arena(Arena({monitor({0, 0, 1000, 700})}, FloorEdge::screen));
    CHECK(world.pet(resting).position() == Vec2{100.0, 620.0});
    CHECK(world.pet(rising).velocity() == Vec2{10.0, -900.0});
    // It goes down again: the resting pet falls from rest.
    world.engine.set_arena(wide);
    world.run(0.1);
    CHECK(world.pet(resting).position().y > 620.0);
    world.run(5.0);
    CHECK(world.pet(resting).position() == Vec2{100.0, 720.0});
    CHECK(world.pet(rising).position().y == 720.0);
}

TEST_CASE("settings reach pets in flight with the next frame") {
    World world;
    const PetId id = world.spawn({300.0, 0.0});
    world.run(0.1);
    const double before = world.pet(id).velocity().y;
    CHECK(world.engine.configure({.physics = {.gravity = 0.0, .air_drag = 1.0}}));
    world.run(0.1);
    CHECK(world.pet(id).velocity().y == before);
}

TEST_CASE("the work area is the floor, unless the config says the screen") {
    const Monitor with_taskbar{
        .bounds = {0, 0, 1920, 1080}, .work = {0, 0, 1920, 1040}, .primary = true, .name = {}
    };
    CHECK(Arena({with_taskbar}, FloorEdge::work_area).boxes()[0].height == 1040);
    CHECK(Arena({with_taskbar}, FloorEdge::screen).boxes()[0].height == 1080);
}

TEST_CASE("kinds are replaced by name") {
    World world;
    const PetId other = *world.engine.spawn({.kind = "other"});
    world.engine.set_kinds({{"another", {10, 10}}, {"other", {60, 60}}});
    CHECK(world.engine.kinds()[world.pet(other).kind].name == "other");
    world.engine.set_kinds({{"hyrax", box}});
    CHECK(world.engine.kinds()[world.pet(other).kind].name == "hyrax");
}

TEST_CASE("a law that nothing can follow is refused, and the old one goes on") {
    World world;
    const EngineSettings before = world.engine.settings();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const PhysicsConstants& law : std::initializer_list<PhysicsConstants>{
             {.gravity = -1.0},
             {.gravity = nan},
             {.gravity = inf},
             {.restitution = 1.0001},
             {.restitution = -0.1},
             {.air_drag = 1.0001},
             {.air_drag = nan},
             {.ground_friction = -0.1},
             {.ground_friction = 2.0},
             {.rest_threshold = -5.0},
             {.rest_threshold = inf},
         }) {
        const Result<void> refused = world.engine.configure({.physics = law});
        REQUIRE_FALSE(refused);
        CHECK(refused.error().message.starts_with("settings: expected finite numbers"));
        CHECK(world.engine.settings() == before);
    }
    CHECK_FALSE(world.engine.configure({.reference_rate = 0.0}));
    CHECK_FALSE(world.engine.configure({.fixed_rate = nan}));
}

TEST_CASE("a clock that goes back changes nothing") {
    World world;
    const PetId id = world.spawn({300.0, 0.0});
    world.run(0.5);
    const Pet before = world.pet(id);
    world.engine.advance(world.now - ticks_per_second);
    CHECK(same(world.pet(id), before));
}
