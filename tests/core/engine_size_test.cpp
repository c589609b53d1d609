// SPDX-License-Identifier: MIT
// Sizes of pets: scales, screens with scales of their own, and the spaces behind them.
#include "daemon/core/spaces.h"
#include "tests/core/engine_world.h"

#include <cmath>
#include <limits>

using namespace hyrax;

namespace {

constexpr EngineSettings weightless{.physics = {.gravity = 0.0, .air_drag = 1.0}};

Vec2 feet(const World& world, PetId id) {
    const Size size = world.engine.box_of(world.pet(id));
    return world.pet(id).position() + Vec2{size.width / 2.0, static_cast<double>(size.height)};
}

Monitor scaled_monitor(Rect bounds, double scale) {
    Monitor made = monitor(bounds);
    made.scale = scale;
    return made;
}

// 100 % on the left, 150 % on the right; both floors at 1080.
Arena two_screens() {
    return Arena(
        {scaled_monitor({0, 0, 1920, 1080}, 1.0), scaled_monitor({1920, 0, 2560, 1080}, 1.5)},
        FloorEdge::screen
    );
}

}  // namespace

TEST_CASE("a pet that changes its scale keeps its feet") {
    World world(weightless);
    const PetId id = world.spawn({500.0, 400.0}, {30.0, 0.0});
    world.run(0.1);
    const Vec2 before = feet(world, id);
    for (const double scale : {2.0, 0.5, 3.3, 0.25, 4.0, 1.0}) {
        REQUIRE(world.engine.set_scale(id, scale));
        CHECK(world.engine.box_of(world.pet(id)) == scaled(box, scale));
        CHECK(feet(world, id) == before);
        CHECK(world.pet(id).velocity() == Vec2{30.0, 0.0});
    }
    const double x = world.pet(id).position().x;
    world.run(1.0);
    CHECK(world.pet(id).position().x > x + 25.0);
}

TEST_CASE("a pet in a corner grows out of it, and stays on its floor") {
    World world;
    const PetId id = world.spawn({0.0, 1000.0});
    world.run(1.0);
    REQUIRE_FALSE(world.engine.moving());
    REQUIRE(world.engine.set_scale(id, 2.0));
    CHECK(world.pet(id).position() == Vec2{0.0, 1080.0 - 160.0});
    world.run(1.0);
    CHECK_FALSE(world.engine.moving());
    CHECK(world.pet(id).position() == Vec2{0.0, 1080.0 - 160.0});
    REQUIRE(world.engine.set_scale(id, 0.5));
    CHECK(world.pet(id).position() == Vec2{75.0, 1080.0 - 40.0});
    world.run(1.0);
    CHECK(feet(world, id).y == 1080.0);
}

TEST_CASE("a larger pet meets the floor with its own feet") {
    World world;
    const Result<PetId> id = world.engine.spawn({.at = Vec2{500.0, 100.0}, .scale = 2.0});
    REQUIRE(id);
    world.run(10.0);
    CHECK(feet(world, *id).y == 1080.0);
    CHECK(world.pet(*id).position().y == 1080.0 - 160.0);
}

TEST_CASE("a scale out of range is refused with its number") {
    World world;
    const PetId id = world.spawn({500.0, 400.0});
    for (const double bad : {0.2, 4.1, -1.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
        CHECK_FALSE(world.engine.set_scale(id, bad));
        CHECK_FALSE(world.engine.spawn({.scale = bad}));
    }
    CHECK(world.pet(id).scale == 1.0);
    CHECK(
        world.engine.set_scale(id, 7.0).error().message ==
        "set_scale: expected a scale from 0.25 to 4, got 7"
    );
    CHECK(world.engine.set_scale({77, 1}, 1.0).error().message == "set_scale: this pet is gone");
}

TEST_CASE("a held pet keeps its feet as well, and flies on from there") {
    World world(weightless);
    const PetId id = world.spawn({500.0, 400.0});
    world.engine.advance(0);
    REQUIRE(world.engine.grab(id, 0));
    REQUIRE(world.engine.carry(id, {600.0, 300.0}, 0));
    world.engine.advance_held(from_seconds(1.0));
    const Vec2 before = feet(world, id);
    REQUIRE(world.engine.set_scale(id, 2.0));
    CHECK(feet(world, id) == before);
    world.engine.advance_held(from_seconds(1.1));
    CHECK(std::fabs(feet(world, id).x - before.x) < 0.01);
    CHECK(std::fabs(feet(world, id).y - before.y) < 0.01);
    CHECK(world.pet(id).motion == Motion::held);
    REQUIRE(world.engine.let_go(id, from_seconds(1.2), 0.0));
    CHECK(std::fabs(feet(world, id).x - before.x) < 0.01);
    CHECK(std::fabs(feet(world, id).y - before.y) < 0.01);
}

TEST_CASE("scales of kind, settings and pet multiply; pixel art takes whole steps") {
    Engine engine(
        {{.name = "hyrax", .box = box, .scale = 1.5},
         {.name = "pixel", .box = box, .scale = 1.0, .whole_scale = true}},
        {.scale = 1.5},
        1
    );
    engine.set_arena(Arena({monitor({0, 0, 1920, 1080})}, FloorEdge::screen));
    const auto drawn = [&engine](const char* kind, double scale) {
        const auto id = engine.spawn({.kind = kind, .at = Vec2{9, 9}, .scale = scale});
        REQUIRE(id);
        return engine.find(*id)->drawn_scale;
    };
    CHECK(drawn("hyrax", 1.0) == 2.25);
    CHECK(drawn("hyrax", 4.0) == 8.0);
    CHECK(drawn("pixel", 1.0) == 2.0);
    CHECK(drawn("pixel", 0.25) == 1.0);
    CHECK(drawn("pixel", 2.0) == 3.0);
    CHECK(engine.usual_box(engine.kinds()[0]) == Size{225, 180});
}

TEST_CASE("new settings and new kinds resize everybody") {
    World world;
    const PetId id = world.spawn({500.0, 1000.0});
    world.run(1.0);
    REQUIRE(world.engine.configure({.scale = 0.5}));
    CHECK(world.engine.box_of(world.pet(id)) == Size{50, 40});
    CHECK(feet(world, id) == Vec2{550.0, 1080.0});
    CHECK_FALSE(world.engine.configure({.scale = 0.1}));
    world.engine.set_kinds({{.name = "hyrax", .box = {60, 60}, .scale = 2.0}});
    CHECK(world.engine.box_of(world.pet(id)) == Size{60, 60});
    CHECK(feet(world, id) == Vec2{550.0, 1080.0});
    world.run(1.0);
    CHECK_FALSE(world.engine.moving());
}

TEST_CASE("a pet takes the scale of its screen once its feet are 16 px inside") {
    World world(weightless);
    world.engine.set_arena(two_screens());
    const PetId id = world.spawn({1700.0, 400.0}, {60.0, 0.0});
    bool grown = false;
    for (Ticks now = 0; now < from_seconds(10.0); now += frame) {
        world.engine.advance(now);
        const Vec2 at = feet(world, id);
        const bool large = world.engine.box_of(world.pet(id)) == scaled(box, 1.5);
        CHECK(large == (at.x >= 1920.0 + 16.0));
        CHECK(at.y == 480.0);
        CHECK(std::fabs(at.x - (1750.0 + 60.0 * to_seconds(now))) < 1e-9);
        grown = grown || large;
    }
    CHECK(grown);
    // Back over the seam, it stays large for 16 px.
    REQUIRE(world.engine.move_to(id, {1930.0 - 75.0, 400.0}));
    CHECK(world.engine.box_of(world.pet(id)) == scaled(box, 1.5));
    REQUIRE(world.engine.move_to(id, {1910.0 - 75.0, 400.0}));
    CHECK(world.engine.box_of(world.pet(id)) == scaled(box, 1.5));
    REQUIRE(world.engine.move_to(id, {1900.0 - 75.0, 400.0}));
    CHECK(world.engine.box_of(world.pet(id)) == box);
    CHECK(world.pet(id).position() == Vec2{1825.0, 400.0});
}

TEST_CASE("screens' scales can be switched off, and change under sleeping and held pets") {
    World world;
    world.engine.set_arena(two_screens());
    const PetId sleeper = world.spawn({2500.0, 900.0});
    CHECK(world.engine.box_of(world.pet(sleeper)) == scaled(box, 1.5));
    world.run(3.0);
    REQUIRE_FALSE(world.engine.moving());
    REQUIRE(world.engine.configure({.scale_with_dpi = false}));
    CHECK(world.engine.box_of(world.pet(sleeper)) == box);
    REQUIRE(world.engine.configure({}));
    CHECK(world.engine.box_of(world.pet(sleeper)) == scaled(box, 1.5));
    CHECK(feet(world, sleeper).y == 1080.0);

    const PetId held = world.spawn({1000.0, 500.0});
    world.engine.advance(world.now);
    REQUIRE(world.engine.grab(held, 0));
    REQUIRE(world.engine.carry(held, {2200.0, 500.0}, 0));
    world.engine.advance_held(from_seconds(1.0));
    CHECK(world.engine.box_of(world.pet(held)) == scaled(box, 1.5));
    CHECK(std::fabs(feet(world, held).x - 2250.0) < 0.01);
    CHECK(std::fabs(feet(world, held).y - 580.0) < 0.01);

    world.engine.set_arena(Arena({scaled_monitor({0, 0, 4480, 1080}, 3.0)}, FloorEdge::screen));
    for (const PetId id : {sleeper, held}) {
        CHECK(world.engine.box_of(world.pet(id)) == scaled(box, 3.0));
    }
    CHECK(std::fabs(feet(world, held).x - 2250.0) < 0.01);
    CHECK(feet(world, sleeper).y == 1080.0);
}

TEST_CASE("spaces are shared by size, keep their index, and follow the arena") {
    Spaces spaces;
    const Arena small({monitor({0, 0, 200, 100})}, FloorEdge::screen);
    spaces.set_arena(small);
    const std::size_t a = spaces.acquire({50, 50});
    const std::size_t b = spaces.acquire({60, 50});
    CHECK(spaces.acquire({50, 50}) == a);
    CHECK(a != b);
    CHECK(spaces.size() == 2);
    CHECK(spaces[b] == small.space_for({60, 50}));

    const Arena large({monitor({0, 0, 400, 300})}, FloorEdge::screen);
    spaces.set_arena(large);
    CHECK(spaces[a] == large.space_for({50, 50}));
    CHECK(spaces[b] == large.space_for({60, 50}));

    spaces.release(a);
    CHECK(spaces.size() == 2);
    spaces.release(a);
    CHECK(spaces.size() == 1);
    // A size that nobody uses any more makes room; the others stay where they are.
    const std::size_t c = spaces.acquire({70, 70});
    CHECK(c == a);
    CHECK(spaces.box(b) == Size{60, 50});
    CHECK(spaces[c] == large.space_for({70, 70}));
}

TEST_CASE("pets that come and go leave no space behind") {
    World world({.max_spawn_rate = 1000.0});
    for (int i = 0; i < 1000; ++i) {
        const PetId id = world.spawn({500.0, 400.0});
        REQUIRE(world.engine.set_scale(id, 0.25 + (i % 300) * 0.01));
        REQUIRE(world.engine.remove(id));
    }
    CHECK(world.engine.sizes_in_use() == 0);
}
