// SPDX-License-Identifier: MIT
// What a caller may get wrong: the interface rows A1 to A10 of the stability catalogue.
#include "physics/steppers.h"
#include "tests/core/engine_seen.h"

#include <cmath>
#include <limits>
#include <type_traits>

using namespace hyrax;

namespace {

using Limits = std::numeric_limits<double>;

constexpr double not_finite[] = {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()};

double speed(const Pet& pet) {
    return std::hypot(pet.velocity().x, pet.velocity().y);
}

}  // namespace

TEST_CASE("A1, A2: a frame takes whole ticks, so no step is NaN or infinite, and the longest ends"
) {
    static_assert(std::is_integral_v<Ticks>);
    for (const Integrator integrator : integrators) {
        CAPTURE(integrator);
        World world({.integrator = integrator});
        const PetId id = world.spawn({300.0, 0.0}, {250.0, 0.0});
        world.run(0.5);
        constexpr Ticks a_century = Ticks{36'500} * 86'400 * ticks_per_second;
        world.engine.advance(a_century);
        for (int i = 1; i <= 600; ++i) {
            world.engine.advance(a_century + i * frame);
        }
        CHECK_FALSE(world.engine.moving());
        CHECK(world.pet(id).velocity() == Vec2{});
        CHECK(world.pet(id).position().y == 1080.0 - box.height);
    }
}

TEST_CASE("A3, A4: time that goes back or stands still changes nothing") {
    for (const Integrator integrator : integrators) {
        CAPTURE(integrator);
        World world({.integrator = integrator});
        World undisturbed({.integrator = integrator});
        const PetId id = world.spawn({300.0, 0.0}, {250.0, -400.0});
        const PetId other = undisturbed.spawn({300.0, 0.0}, {250.0, -400.0});
        world.run(0.5);
        undisturbed.run(0.5);
        const Pet before = world.pet(id);
        for (const Ticks now : {world.now - frame, Ticks{0}, Ticks{-1}, -never}) {
            world.engine.advance(now);
            CHECK(same(world.pet(id), before));
        }
        for (int i = 0; i < 1000; ++i) {
            world.engine.advance(world.now - frame);
        }
        CHECK(same(world.pet(id), before));
        world.run(1.0);
        undisturbed.run(1.0);
        CHECK(same(world.pet(id), undisturbed.pet(other)));
    }
}

TEST_CASE("A5: numbers that are not finite are refused, and leave every bit as it was") {
    for (const Integrator integrator : integrators) {
        CAPTURE(integrator);
        World world({.integrator = integrator});
        World undisturbed({.integrator = integrator});
        const PetId id = world.spawn({300.0, 0.0}, {250.0, 0.0});
        const PetId other = undisturbed.spawn({300.0, 0.0}, {250.0, 0.0});
        world.run(0.3);
        undisturbed.run(0.3);
        const Seen before(world.engine);
        for (const double bad : not_finite) {
            for (const Vec2 numbers : {Vec2{bad, 0.0}, Vec2{0.0, bad}, Vec2{bad, bad}}) {
                CHECK_FALSE(world.engine.spawn({.at = numbers}));
                CHECK_FALSE(world.engine.spawn({.at = Vec2{}, .velocity = numbers}));
                CHECK_FALSE(world.engine.fling(id, numbers));
                CHECK_FALSE(world.engine.push(id, numbers));
                CHECK_FALSE(world.engine.move_to(id, numbers));
                CHECK(same(Seen(world.engine), before));
            }
        }
        CHECK(world.count(EventKind::throw_pet) == 0);
        world.run(1.0);
        undisturbed.run(1.0);
        CHECK(same(world.pet(id), undisturbed.pet(other)));
    }
}

TEST_CASE("A5: a hand that loses its numbers loses nothing else") {
    World world;
    const PetId id = world.spawn({300.0, 100.0});
    CHECK(world.engine.grab(id, 0));
    CHECK(world.engine.carry(id, {310.0, 100.0}, 8 * ticks_per_ms));
    world.engine.advance_held(10 * ticks_per_ms);
    const Seen before(world.engine);
    for (const double bad : not_finite) {
        CHECK_FALSE(world.engine.carry(id, {bad, 0.0}, 16 * ticks_per_ms));
        CHECK_FALSE(world.engine.carry(id, {0.0, bad}, 16 * ticks_per_ms));
        CHECK_FALSE(world.engine.let_go(id, 16 * ticks_per_ms, bad));
        world.engine.advance_held(10 * ticks_per_ms);
        CHECK(same(Seen(world.engine), before));
    }
    CHECK(world.engine.let_go(id, 16 * ticks_per_ms, 1000.0));
    CHECK(world.pet(id).motion == Motion::airborne);
}

TEST_CASE("A6: a pet that is larger than its room is pinned to one place along that axis") {
    for (const Integrator integrator : integrators) {
        CAPTURE(integrator);
        for (const Rect room : {Rect{0, 0, 60, 1080}, Rect{0, 0, 1920, 40}, Rect{0, 0, 60, 40}}) {
            CAPTURE(room.width);
            CAPTURE(room.height);
            World world({.integrator = integrator});
            world.engine.set_arena(one_monitor(room));
            const PetId id = world.spawn({10.0, 10.0}, {500.0, -700.0});
            world.engine.advance(0);
            const Vec2 first = world.pet(id).position();
            for (int i = 1; i < 600; ++i) {
                world.engine.advance(i * frame);
                const Vec2 now = world.pet(id).position();
                REQUIRE((room.width > box.width || now.x == first.x));
                REQUIRE((room.height > box.height || now.y == first.y));
            }
            CHECK_FALSE(world.engine.moving());
        }
    }
}

TEST_CASE("A7: constants that no law can have are refused, and leave every bit as it was") {
    World world;
    const PetId id = world.spawn({300.0, 0.0}, {250.0, 0.0});
    world.run(0.3);
    const Seen before(world.engine);
    const auto refused = [&](auto set) {
        EngineSettings settings;
        set(settings);
        return !world.engine.configure(settings) && same(Seen(world.engine), before);
    };
    for (const double bad : {-1e-300, -1.0, not_finite[0], not_finite[1], not_finite[2]}) {
        CAPTURE(bad);
        CHECK(refused([bad](EngineSettings& s) { s.physics.gravity = bad; }));
        CHECK(refused([bad](EngineSettings& s) { s.physics.rest_threshold = bad; }));
        CHECK(refused([bad](EngineSettings& s) { s.physics.air_drag = bad; }));
        CHECK(refused([bad](EngineSettings& s) { s.physics.restitution = bad; }));
        CHECK(refused([bad](EngineSettings& s) { s.physics.ground_friction = bad; }));
        CHECK(refused([bad](EngineSettings& s) { s.reference_rate = bad; }));
        CHECK(refused([bad](EngineSettings& s) { s.fixed_rate = bad; }));
        CHECK(refused([bad](EngineSettings& s) { s.max_speed = bad; }));
    }
    const double above_one = std::nextafter(1.0, 2.0);
    CHECK(refused([above_one](EngineSettings& s) { s.physics.air_drag = above_one; }));
    CHECK(refused([above_one](EngineSettings& s) { s.physics.restitution = above_one; }));
    CHECK(refused([above_one](EngineSettings& s) { s.physics.ground_friction = above_one; }));
    CHECK(refused([](EngineSettings& s) { s.reference_rate = 0.0; }));
    CHECK(refused([](EngineSettings& s) { s.fixed_rate = 0.0; }));
    world.run(10.0);
    CHECK(world.pet(id).velocity() == Vec2{});
}

TEST_CASE("A8: a velocity above the limit is shortened once, where it comes in") {
    World world({.max_speed = 1e7});
    const PetId id = world.spawn({300.0, 300.0}, {1e308, -1e308});
    const double diagonal = 1e7 / std::sqrt(2.0);
    const auto check_capped = [&](Vec2 expected) {
        CHECK(world.pet(id).velocity().x == doctest::Approx(expected.x));
        CHECK(world.pet(id).velocity().y == doctest::Approx(expected.y));
        CHECK(speed(world.pet(id)) <= 1e7 * (1.0 + 1e-15));
    };
    check_capped({diagonal, -diagonal});
    CHECK(world.engine.fling(id, {Limits::max(), 0.0}));
    check_capped({1e7, 0.0});
    CHECK(world.engine.push(id, {Limits::max(), Limits::max()}));
    check_capped({diagonal, diagonal});
    CHECK(world.engine.fling(id, {3e6, -4e6}));
    check_capped({3e6, -4e6});
    CHECK(world.engine.push(id, {-3e6, 4e6}));
    check_capped({});
}

TEST_CASE("A9: a floor that sinks lets a resting pet fall from a stand, one that rises lifts it") {
    for (const Integrator integrator : integrators) {
        CAPTURE(integrator);
        World world({.integrator = integrator});
        const PetId id = world.spawn({300.0, 900.0});
        world.run(5.0);
        REQUIRE_FALSE(world.engine.moving());

        world.engine.set_arena(one_monitor({0, 0, 1920, 1280}));
        CHECK(world.pet(id).position() == Vec2{300.0, 1080.0 - box.height});
        CHECK(world.pet(id).velocity() == Vec2{});
        double previous = world.pet(id).position().y;
        for (int i = 0; i < 20; ++i) {
            world.engine.advance(world.now += frame);
            REQUIRE(world.pet(id).position().y >= previous);
            previous = world.pet(id).position().y;
        }
        CHECK(world.pet(id).velocity().y > 100.0);
        world.run(5.0);
        CHECK(world.pet(id).position() == Vec2{300.0, 1280.0 - box.height});

        world.engine.set_arena(one_monitor({0, 0, 1920, 980}));
        CHECK(world.pet(id).position() == Vec2{300.0, 980.0 - box.height});
        world.run(1.0);
        CHECK(world.pet(id).position() == Vec2{300.0, 980.0 - box.height});
        CHECK(world.pet(id).velocity() == Vec2{});
        CHECK_FALSE(world.engine.moving());
    }
}
