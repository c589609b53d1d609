// SPDX-License-Identifier: MIT
// Where two things happen at once, or nothing is left between two sides: corners, slots, rooms as
// small as the body, and motions with too many events to follow.
#include "tests/physics/random_scene.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <vector>

using namespace hyrax;
using namespace hyrax::test;

namespace {

// A scene that reaches (corner) after `t` with velocity (arrival), computed backwards.
Scene aimed(const Law& law, const FreeSpace& space, Vec2 corner, Vec2 arrival, double t) {
    const double grown = std::exp(law.drag * t);
    const double mean = law.drag == 0.0 ? t : std::expm1(law.drag * t) / law.drag;
    const double fall = law.drag == 0.0 ? law.gravity * t : law.gravity * mean;
    Scene scene{law, space, corner, {arrival.x * grown, arrival.y * grown - fall}};
    const BodyState there = free_motion({{}, scene.velocity, Mode::air}, law, t);
    scene.position = corner - there.position;
    return scene;
}

struct Found {
    std::size_t events = 0;
    Mode mode = Mode::air;
    Vec2 place;
};

// Also sees that no read leaves the space.
Found after(const Scene& scene, double seconds) {
    Run run(scene);
    BodyState state;
    for (int read = 0; read <= 400; ++read) {
        state = run.at(from_seconds(seconds * read / 400.0));
        CHECK(depth_inside(scene.space, state.position) <= 1e-9);
    }
    return {run.events.size(), state.mode, state.position};
}

FreeSpace hall_with(std::vector<Obstacle> obstacles) {
    obstacles.push_back({.right = 0.0});
    obstacles.push_back({.left = 1000.0});
    obstacles.push_back({.bottom = 0.0});
    obstacles.push_back({.top = 1000.0});
    return FreeSpace(std::move(obstacles));
}

}  // namespace

TEST_CASE("a body that aims at a corner, to the last bit, does not slip into the solid") {
    int tried = 0;
    for (std::uint64_t seed = 1; seed <= 60'000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Law law = random.one_in(2) ? law_from({}) : elastic_law(1200.0);
        if (random.one_in(4)) {
            law.gravity = 0.0;
        }
        const Obstacle solid{
            static_cast<double>(random.whole(300, 500)),
            static_cast<double>(random.whole(300, 450)),
            static_cast<double>(random.whole(510, 700)),
            static_cast<double>(random.whole(460, 700))
        };
        const FreeSpace space = hall_with({solid});
        const bool left = random.one_in(2);
        const bool upper = random.one_in(2);
        const Vec2 corner{left ? solid.left : solid.right, upper ? solid.top : solid.bottom};
        const Vec2 arrival{
            random.between(20.0, 600.0) * (left ? 1.0 : -1.0),
            random.between(5.0, 900.0) * (upper ? 1.0 : -1.0)
        };
        const double t = random.between(0.05, 1.0);
        Scene scene = aimed(law, space, corner, arrival, t);
        for (int nudge = random.whole(0, 3); nudge > 0; --nudge) {
            scene.position.y = std::nextafter(scene.position.y, random.one_in(2) ? 1e9 : -1e9);
        }
        if (!space.contains(scene.position)) {
            continue;
        }
        ++tried;
        Run run(scene);
        const Ticks there = from_seconds(t);
        for (const Ticks read :
             {there - 1,
              there,
              there + 1,
              there + ticks_per_second / 50,
              there + ticks_per_second / 10}) {
            CHECK(depth_inside(space, run.at(read).position) <= 1e-9);
        }
    }
    CHECK(tried > 20'000);
}

TEST_CASE("a body that lands exactly on the end of a floor slides along it and off its other end") {
    Law law = elastic_law(1200.0);
    law.restitution = 0.0;
    law.rest_speed = 5.0;
    const FreeSpace space = hall_with({{100.0, 700.0, 130.0, 1100.0}});
    for (const double direction : {1.0, -1.0}) {
        CAPTURE(direction);
        const Vec2 from{direction > 0.0 ? 40.0 : 190.0, 100.0};
        Scene scene{law, space, from, {60.0 * direction, 0.0}};
        Run run(scene);
        // A parabola of 600 px takes one second.
        CHECK(run.at(ticks_per_second).mode == Mode::ground);
        CHECK(run.at(from_seconds(1.25)).position == Vec2{115.0, 700.0});
        CHECK(run.at(from_seconds(1.6)).mode == Mode::air);
        CHECK(run.at(from_seconds(1.6)).position.y == doctest::Approx(706.0));
    }
}

TEST_CASE("in a slot as wide as the body nothing repeats for ever") {
    const FreeSpace space =
        hall_with({{-100.0, 500.0, 100.0, 1100.0}, {100.0, 500.0, 400.0, 1100.0}});
    for (const double restitution : {0.0, 0.6, 1.0}) {
        CAPTURE(restitution);
        Law law = law_from({});
        law.restitution = restitution;
        for (const Vec2 velocity : {Vec2{50.0, 100.0}, Vec2{0.0, 100.0}, Vec2{-3000.0, -100.0}}) {
            for (const double y : {500.0, 700.0, 1000.0}) {
                CAPTURE(y);
                const Found found = after({law, space, {100.0, y}, velocity}, 4.0);
                CHECK(found.events < 100);
            }
        }
        // What falls in straight stays in, and a slide is not stopped by it.
        CHECK(after({law, space, {100.0, 400.0}, {}}, 3.0).place.x == 100.0);
        CHECK(after({law, space, {60.0, 500.0}, {900.0, 0.0}}, 3.0).place.x > 101.0);
    }
}

TEST_CASE("a body as large as its room ends at rest in it") {
    for (const double restitution : {0.0, 0.6, 0.99, 1.0}) {
        for (const double gravity : {0.0, 1e-3, 1200.0}) {
            CAPTURE(restitution);
            CAPTURE(gravity);
            Law law = law_from({.gravity = gravity});
            law.restitution = restitution;
            for (const Vec2 velocity : {Vec2{300.0, -500.0}, Vec2{300.0, 500.0}, Vec2{0.0, -1.0}}) {
                const FreeSpace flat = FreeSpace::box(0.0, 100.0, 900.0, 100.0);
                CHECK(after({law, flat, {10.0, 100.0}, velocity}, 120.0).place.y == 100.0);
                const FreeSpace none = FreeSpace::box(10.0, 100.0, 10.0, 100.0);
                const Found stuck = after({law, none, {10.0, 100.0}, velocity}, 120.0);
                CHECK(stuck.mode == Mode::rest);
                CHECK(stuck.place == Vec2{10.0, 100.0});
                CHECK(stuck.events <= Trajectory::most_events + 2);
            }
        }
    }
}

TEST_CASE("a motion that is given up stays on its floor, not on one below it") {
    // A shaft that stands on a shelf above the floor of the hall.
    const FreeSpace space =
        hall_with({{-100.0, 500.0, 700.0, 600.0}, {680.0, -100.0, 1100.0, 600.0}});
    Law law = elastic_law(1e9);
    SUBCASE("a slide from wall to wall") {
        law.rest_speed = 5.0;
        Run run({law, space, {650.0, 500.0}, {1e6, 0.0}});
        CHECK(run.at(10 * ticks_per_second).position.y == 500.0);
        CHECK(run.events.size() == Trajectory::most_events);
    }
    SUBCASE("hops") {
        Run run({law, space, {650.0, 500.0}, {1000.0, -10.0}});
        CHECK(run.at(10 * ticks_per_second).position.y == 500.0);
        CHECK(run.events.size() == Trajectory::most_events);
    }
}

TEST_CASE("no speed is too high: every read is finite and inside, and no advance is endless") {
    for (const double speed : {1e5, 1e7, 1e12, 1e30, 1e100, 1e200, 1e307}) {
        for (const double drag : {0.0, 1e-9, 0.06, 1e4, 1e30}) {
            for (const WallEvents walls : {WallEvents::wanted, WallEvents::not_wanted}) {
                CAPTURE(speed);
                CAPTURE(drag);
                Law law = law_from({});
                law.drag = drag;
                law.restitution = drag == 0.0 ? 1.0 : 0.6;
                const FreeSpace space = FreeSpace::box(0.0, 0.0, 1792.0, 952.0);
                const Scene scene{law, space, {10.0, 100.0}, {speed, -speed}};
                Run run(scene, walls);
                for (const double t : {0.0, 1e-9, 0.01, 1.0, 60.0, 3600.0}) {
                    CAPTURE(t);
                    const std::size_t before = run.events.size();
                    const BodyState state = run.at(from_seconds(t));
                    CHECK(depth_inside(space, state.position) <= 1e-9);
                    CHECK(std::isfinite(state.velocity.x));
                    CHECK(std::isfinite(state.velocity.y));
                    CHECK(run.events.size() - before <= Trajectory::most_events);
                }
            }
        }
    }
}
