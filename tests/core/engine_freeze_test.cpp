// SPDX-License-Identifier: MIT
// Pets that stand still for a while have lost no motion and no pose.
#include "tests/core/engine_seen.h"

#include <string>

using namespace hyrax;

namespace {

constexpr Rect left{0, 0, 1000, 800};
constexpr Rect right{1000, 0, 1000, 800};

Arena two_monitors() {
    return Arena({monitor(left), monitor(right)}, FloorEdge::work_area);
}

}  // namespace

TEST_CASE("a frozen pet goes on exactly where it was, with every integrator") {
    for (const Integrator integrator : integrators) {
        CAPTURE(static_cast<int>(integrator));
        World world({.integrator = integrator});
        World twin({.integrator = integrator});
        for (World* one : {&world, &twin}) {
            one->engine.set_arena(two_monitors());
        }
        const PetId id = world.spawn({300.0, 100.0}, {90.0, -100.0});
        const PetId other = twin.spawn({300.0, 100.0}, {90.0, -100.0});
        world.run(0.5);
        twin.run(0.5);
        const Vec2 before = world.pet(id).position();
        world.engine.freeze({left}, world.now - frame);
        CHECK_FALSE(world.engine.moving());
        const Ticks stopped = world.now;
        world.run(7.0);
        CHECK(world.pet(id).position() == before);
        world.engine.freeze({}, world.now - frame);
        CHECK(world.engine.moving());
        const Ticks lost = world.now - stopped;
        for (int i = 0; i < 300; ++i, world.now += frame, twin.now += frame) {
            world.engine.advance(world.now);
            twin.engine.advance(twin.now);
            REQUIRE(world.pet(id).position() == twin.pet(other).position());
            REQUIRE(world.pet(id).motion == twin.pet(other).motion);
            if (world.pet(id).motion == Motion::settled) {
                REQUIRE(world.pet(id).since == twin.pet(other).since + lost);
            }
        }
    }
}

TEST_CASE("frozen pets do not walk, and walk on in a time of their own") {
    World world;
    world.engine.set_arena(two_monitors());
    const PetId id = world.spawn({300.0, 800.0});
    world.run(0.5);
    const double y = world.pet(id).position().y;
    SUBCASE("in the middle of it") {
        REQUIRE(world.engine.walk_to(id, 600.0, 100.0));
        world.run(1.0);
        const Vec2 before = world.pet(id).position();
        CHECK(before.x > 350.0);
        world.engine.freeze({left}, world.now - frame);
        world.run(5.0);
        CHECK(world.pet(id).position() == before);
        world.engine.freeze({}, world.now - frame);
        world.run(0.5);
        CHECK(world.pet(id).motion == Motion::walking);
        CHECK(world.pet(id).position().x == doctest::Approx(before.x + 50.0).epsilon(0.01));
    }
    SUBCASE("asked while frozen") {
        world.engine.freeze({left}, world.now - frame);
        REQUIRE(world.engine.walk_to(id, 600.0, 100.0));
        CHECK_FALSE(world.engine.moving());
        world.run(5.0);
        CHECK(world.pet(id).position().x == 300.0);
        world.engine.freeze({}, world.now - frame);
        world.run(1.0);
        CHECK(world.pet(id).position().x == doctest::Approx(400.0).epsilon(0.01));
    }
    world.run(6.0);
    CHECK(world.pet(id).position() == Vec2{600.0, y});
}

TEST_CASE("an animation that was asked for goes on where it was, too") {
    World world;
    world.engine.set_arena(two_monitors());
    const PetId id = world.spawn({300.0, 800.0});
    world.run(1.0);
    REQUIRE(world.engine.play(id, {.animation = "any"}));
    const Ticks since = world.pet(id).playing->since;
    world.engine.freeze({left}, world.now - frame);
    const Ticks stopped = world.now - frame;
    world.run(3.0);
    world.engine.freeze({}, world.now - frame);
    CHECK(world.pet(id).playing->since == since + (world.now - frame - stopped));
}

TEST_CASE("a pet that was frozen changes its size on the next screen as any other") {
    World world({.physics = {.gravity = 0.0, .air_drag = 1.0}});
    World twin({.physics = {.gravity = 0.0, .air_drag = 1.0}});
    Monitor larger = monitor(right);
    larger.scale = 2.0;
    for (World* one : {&world, &twin}) {
        one->engine.set_arena(Arena({monitor(left), larger}, FloorEdge::work_area));
    }
    const PetId id = world.spawn({700.0, 100.0}, {300.0, 0.0});
    const PetId other = twin.spawn({700.0, 100.0}, {300.0, 0.0});
    world.run(0.2);
    twin.run(0.2);
    world.engine.freeze({left}, world.now - frame);
    world.run(7.0);
    world.engine.freeze({}, world.now - frame);
    for (int i = 0; i < 150; ++i, world.now += frame, twin.now += frame) {
        world.engine.advance(world.now);
        twin.engine.advance(twin.now);
        REQUIRE(world.pet(id).position() == twin.pet(other).position());
    }
    CHECK(world.engine.box_of(world.pet(id)) == Size{2 * box.width, 2 * box.height});
}

TEST_CASE("pets on other monitors go on, and one that flies in stops there") {
    World world;
    world.engine.set_arena(two_monitors());
    const PetId stays = world.spawn({300.0, 100.0});
    const PetId goes = world.spawn({1500.0, 100.0}, {-900.0, -300.0});
    world.engine.freeze({left}, 0);
    world.run(0.3);
    CHECK(world.pet(stays).position() == Vec2{300.0, 100.0});
    CHECK(world.pet(goes).position().x < 1500.0);
    world.run(3.0);
    const double middle = world.pet(goes).position().x + box.width / 2.0;
    CHECK(middle < 1000.0);
    CHECK(middle > 960.0);
    CHECK(world.pet(goes).velocity().x < -500.0);
    CHECK_FALSE(world.engine.moving());
    world.engine.freeze({}, world.now);
    world.run(1.0);
    CHECK(world.pet(stays).position().y > 200.0);
    CHECK(world.pet(goes).position().x < 900.0);
}

TEST_CASE("what is asked of a frozen pet happens when it may move again") {
    World world;
    world.engine.set_arena(two_monitors());
    const PetId id = world.spawn({300.0, 700.0});
    world.run(3.0);
    CHECK_FALSE(world.engine.moving());
    world.engine.freeze({left}, world.now);
    REQUIRE(world.engine.fling(id, {0.0, -500.0}));
    CHECK_FALSE(world.engine.moving());
    world.run(1.0);
    CHECK(world.pet(id).position().y == 720.0);
    world.engine.freeze({}, world.now);
    world.run(0.2);
    CHECK(world.pet(id).position().y < 700.0);
    CHECK(world.pet(id).since > 3 * ticks_per_second);
}

TEST_CASE("a pet that is carried or put out of the area moves at once") {
    World world;
    world.engine.set_arena(two_monitors());
    const PetId put = world.spawn({300.0, 100.0});
    const PetId carried = world.spawn({500.0, 100.0});
    const PetId removed = world.spawn({700.0, 100.0});
    world.engine.freeze({left}, 0);
    REQUIRE(world.engine.move_to(put, {1200.0, 100.0}));
    CHECK(world.engine.awake_count() == 1);
    REQUIRE(world.engine.move_to(put, {200.0, 100.0}));
    CHECK(world.engine.awake_count() == 0);
    REQUIRE(world.engine.move_to(put, {1200.0, 100.0}));
    CHECK(world.engine.awake_count() == 1);

    REQUIRE(world.engine.grab(carried, 0));
    CHECK_FALSE(world.pet(carried).frozen());
    REQUIRE(world.engine.carry(carried, {1500.0, 200.0}, frame));
    REQUIRE(world.engine.let_go(carried, 2 * ticks_per_second, 0.0));
    CHECK(world.engine.awake_count() == 2);

    REQUIRE(world.engine.remove(removed));
    world.run(0.5);
    CHECK(world.pet(put).position().y > 150.0);
    world.engine.freeze({}, world.now);
    world.run(10.0);
    CHECK_FALSE(world.engine.moving());
}

TEST_CASE("a pet whose frozen monitor goes away lives on the other one") {
    World world;
    world.engine.set_arena(two_monitors());
    const PetId id = world.spawn({1300.0, 100.0}, {100.0, 0.0});
    world.engine.freeze({right}, 0);
    world.engine.set_arena(one_monitor(left));
    world.engine.freeze({}, frame);
    world.run(10.0);
    CHECK(world.pet(id).position() == Vec2{900.0, 720.0});
    CHECK_FALSE(world.engine.moving());
}
