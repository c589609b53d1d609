// SPDX-License-Identifier: MIT
// Pets on the tops of windows that move, close and are covered.
#include "tests/core/engine_world.h"
#include "tests/physics/random_scene.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace hyrax;

namespace {

LedgeSegment top_of(std::uint64_t window, Rect bounds) {
    return {{bounds.x, bounds.right(), bounds.y}, window, bounds};
}

const Rect place{600, 500, 400, 300};

// A pet of 100 x 80 that rests on the window's top.
struct OnWindow : World {
    explicit OnWindow(EngineSettings settings = {}) : World(settings) {
        engine.set_ledges({top_of(7, place)});
        id = spawn({700.0, 100.0});
        run(6.0);
        REQUIRE(pet(id).position() == Vec2{700.0, 420.0});
        REQUIRE_FALSE(engine.moving());
        engine.take_events();
    }
    PetId id;
};

}  // namespace

TEST_CASE("engine ledges: a pet lands on a window and sleeps there") {
    OnWindow world;
    CHECK(world.pet(world.id).motion == Motion::settled);
    CHECK(world.engine.windows_underfoot() == std::vector<std::uint64_t>{7});
    CHECK_FALSE(world.engine.may_meet_ledges());
}

TEST_CASE("engine ledges: a window counts half a second before a pet comes down on it") {
    // 320 px of fall take 0.73 s without drag.
    EngineSettings settings;
    settings.physics.air_drag = 1.0;
    World world(settings);
    world.engine.set_ledges({top_of(7, place), top_of(8, {0, 500, 300, 300})});
    world.run(2.0);
    const PetId falls = world.spawn({700.0, 100.0});
    CHECK(world.engine.windows_underfoot().empty());
    world.run(0.1);
    CHECK(world.engine.windows_underfoot().empty());
    world.run(0.2);
    CHECK(world.pet(falls).motion == Motion::airborne);
    CHECK(world.engine.windows_underfoot() == std::vector<std::uint64_t>{7});
    world.spawn({1200.0, 400.0});  // beside both
    world.run(0.1);
    CHECK(world.engine.windows_underfoot() == std::vector<std::uint64_t>{7});
}

TEST_CASE("engine ledges: a window that moves gently takes its pets along") {
    OnWindow world;
    const Ticks since = world.pet(world.id).since;
    world.engine.set_ledges({top_of(7, {650, 380, 400, 300})});
    CHECK(world.pet(world.id).position() == Vec2{750.0, 300.0});
    world.run(0.1);
    CHECK(world.pet(world.id).position() == Vec2{750.0, 300.0});
    CHECK_FALSE(world.engine.moving());
    // It has not stood up: who sleeps sleeps on.
    CHECK(world.pet(world.id).since == since);
    CHECK(world.count(EventKind::land) == 0);
}

TEST_CASE("engine ledges: who walks on a window stands on it as on a floor") {
    OnWindow world;
    REQUIRE(world.engine.walk_to(world.id, 900.0, 100.0));
    world.run(1.0);
    CHECK(world.pet(world.id).motion == Motion::walking);
    CHECK(world.pet(world.id).position().y == 420.0);
    CHECK(world.engine.windows_underfoot() == std::vector<std::uint64_t>{7});
    SUBCASE("to its target") {
        world.run(2.0);
        CHECK(world.pet(world.id).position() == Vec2{900.0, 420.0});
        CHECK_FALSE(world.engine.moving());
    }
    SUBCASE("a window elsewhere changes nothing, to the bit") {
        OnWindow twin;
        REQUIRE(twin.engine.walk_to(twin.id, 900.0, 100.0));
        twin.run(1.0);
        world.engine.set_ledges({top_of(7, place), top_of(8, {100, 900, 300, 100})});
        for (int i = 0; i < 100; ++i) {
            world.run(0.02);
            twin.run(0.02);
            REQUIRE(world.pet(world.id).position() == twin.pet(twin.id).position());
        }
    }
    SUBCASE("along with it") {
        world.engine.set_ledges({top_of(7, {600, 480, 400, 300})});
        CHECK(world.pet(world.id).position().y == 400.0);
        world.run(2.0);
        CHECK(world.pet(world.id).position() == Vec2{900.0, 400.0});
    }
    SUBCASE("over the edge that has come nearer") {
        // Until it would be at its target, were the edge still where it was.
        world.engine.set_ledges({top_of(7, {600, 500, 250, 300})});
        world.run(0.7);
        CHECK(world.pet(world.id).motion == Motion::airborne);
        CHECK(world.pet(world.id).position().x > 840.0);
    }
    SUBCASE("and falls when it goes") {
        world.engine.set_ledges({});
        world.run(0.2);
        CHECK(world.pet(world.id).motion == Motion::airborne);
    }
}

TEST_CASE("engine ledges: a window that is yanked leaves its pets behind, either way") {
    for (const int y : {700, 300}) {
        CAPTURE(y);
        OnWindow world;
        world.engine.set_ledges({top_of(7, {600, y, 400, 300})});
        CHECK(world.pet(world.id).position() == Vec2{700.0, 420.0});
        world.run(0.2);
        CHECK(world.pet(world.id).motion == Motion::airborne);
        world.run(6.0);
        CHECK(world.pet(world.id).position().y == (y == 700 ? 620.0 : 1000.0));
        CHECK(world.count(EventKind::land) == 1);
    }
    OnWindow world;
    world.engine.set_ledges({top_of(7, {600, 699, 400, 300})});
    CHECK(world.pet(world.id).position() == Vec2{700.0, 619.0});
}

TEST_CASE("engine ledges: a pet falls when its window closes, and begins where it was") {
    OnWindow world;
    world.now += 3600 * ticks_per_second;
    world.engine.set_ledges({});
    world.engine.advance(world.now);
    CHECK(world.pet(world.id).position() == Vec2{700.0, 420.0});
    world.engine.advance(world.now + frame);
    CHECK(world.pet(world.id).position().y == doctest::Approx(420.0 + 600.0 / 3600.0));
    world.now += frame;
    world.run(6.0);
    CHECK(world.pet(world.id).position().y == 1000.0);
}

TEST_CASE("engine ledges: a pet falls where its window is covered, and beside it stays") {
    OnWindow world;
    const PetId beside = world.spawn({880.0, 100.0});
    world.run(6.0);
    world.engine.set_ledges({{{850, 1000, 500}, 7, place}});
    world.run(6.0);
    CHECK(world.pet(world.id).position().y == 1000.0);
    CHECK(world.pet(beside).position().y == 420.0);
}

TEST_CASE("engine ledges: a window that is resized moves nobody sideways") {
    OnWindow world;
    world.engine.set_ledges({top_of(7, {500, 480, 500, 320})});
    CHECK(world.pet(world.id).position() == Vec2{700.0, 400.0});
    CHECK(world.engine.moving());
    world.run(0.1);
    CHECK_FALSE(world.engine.moving());
}

TEST_CASE("engine ledges: a window that is pushed into the floor leaves its pet on the floor") {
    OnWindow world;
    for (int y = 600; y <= 1100; y += 100) {
        world.engine.set_ledges({top_of(7, {600, y, 400, 300})});
        world.run(0.1);
        CHECK(world.pet(world.id).position().y == std::fmin(y - 80.0, 1000.0));
    }
    // On the floor it stays when the window goes.
    world.engine.set_ledges({});
    CHECK_FALSE(world.engine.moving());
}

TEST_CASE("engine ledges: a pet on the floor is not carried by a window that ends there too") {
    World world;
    const PetId id = world.spawn({700.0, 1000.0});
    world.run(0.1);
    world.engine.set_ledges({top_of(7, {600, 1080, 400, 300})});
    CHECK(world.engine.windows_underfoot().empty());
    world.engine.set_ledges({top_of(7, {600, 1000, 400, 300})});
    CHECK(world.pet(id).position() == Vec2{700.0, 1000.0});
    CHECK_FALSE(world.engine.moving());
}

TEST_CASE("engine ledges: a change that a flight does not meet changes no bit of it") {
    for (const Integrator integrator : {
             Integrator::event_driven,
             Integrator::exponential_swept,
             Integrator::stormer_verlet,
             Integrator::rk45,
         }) {
        CAPTURE(static_cast<int>(integrator));
        EngineSettings settings;
        settings.integrator = integrator;
        World calm(settings);
        World busy(settings);
        for (World* const world : {&calm, &busy}) {
            world->engine.set_ledges({top_of(7, place)});
            world->spawn({650.0, 100.0}, {37.0, -300.0});
        }
        bool same_bits = true;
        for (int i = 0; i < 200; ++i) {
            calm.run(0.02);
            busy.run(0.02);
            const LedgeSegment distant = top_of(9, {1300 + i, 400 + i, 200, 100});
            busy.engine.set_ledges({distant, top_of(7, place)});
            calm.engine.for_each([&](PetId id, const Pet& pet) {
                same_bits = same_bits && same(pet, busy.pet(id));
            });
        }
        CHECK(same_bits);
        CHECK_FALSE(busy.engine.moving());
    }
}

TEST_CASE("engine ledges: a flight heeds a window that comes into its way, without a pause") {
    World world;
    const PetId id = world.spawn({700.0, 100.0});
    world.run(0.3);
    const double before = world.pet(id).position().y;
    world.engine.set_ledges({top_of(7, place)});
    world.engine.advance(world.now);
    CHECK(world.pet(id).position().y > before + 4.0);
    world.run(6.0);
    CHECK(world.pet(id).position().y == 420.0);
    // And one that goes out of its way.
    static_cast<void>(world.engine.fling(id, {0.0, -500.0}));
    world.run(0.2);
    world.engine.set_ledges({});
    world.run(6.0);
    CHECK(world.pet(id).position().y == 1000.0);
}

TEST_CASE("engine ledges: the document's law knows none") {
    EngineSettings settings;
    settings.integrator = Integrator::semi_implicit_euler;
    World world(settings);
    world.engine.set_ledges({top_of(7, place)});
    const PetId id = world.spawn({700.0, 100.0});
    CHECK_FALSE(world.engine.may_meet_ledges());
    world.run(8.0);
    CHECK(world.pet(id).position().y == 1000.0);
    CHECK(world.engine.windows_underfoot().empty());
}

TEST_CASE("engine ledges: they outlive a change of monitors") {
    OnWindow world;
    world.engine.set_arena(
        Arena({monitor({0, 0, 1920, 1080}), monitor({1920, 0, 800, 600})}, FloorEdge::work_area)
    );
    world.run(0.2);
    CHECK(world.pet(world.id).position() == Vec2{700.0, 420.0});
    CHECK_FALSE(world.engine.moving());
}

TEST_CASE("engine ledges: windows that do anything lose nobody and leave nobody in the air") {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        EngineSettings settings;
        settings.integrator = random.one_in(2) ? Integrator::event_driven : Integrator::rk45;
        World world(settings);
        for (int i = 0; i < 6; ++i) {
            world.spawn({random.between(0.0, 1800.0), random.between(0.0, 900.0)});
        }
        for (int change = 0; change < 60; ++change) {
            std::vector<LedgeSegment> ledges;
            const int count = random.whole(0, 5);
            for (int i = 0; i < count; ++i) {
                ledges.push_back(top_of(
                    random.below(4),
                    {random.whole(-200, 1800), random.whole(0, 1200), random.whole(64, 900), 100}
                ));
            }
            world.engine.set_ledges(ledges);
            world.run(random.between(0.0, 0.3));
            world.engine.for_each([&](PetId, const Pet& pet) {
                const FreeSpace space = world.engine.arena().space_for(box);
                CHECK(space.nearest(pet.position()) == pet.position());
                const bool rests = !pet.awake && pet.motion == Motion::settled;
                CHECK((!rests || space.support(pet.position())));
            });
        }
        world.engine.set_ledges({});
        world.run(15.0);
        world.engine.for_each([&](PetId, const Pet& pet) { CHECK(pet.position().y == 1000.0); });
    }
}
