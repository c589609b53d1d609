// SPDX-License-Identifier: MIT
// What must hold for every trajectory: bounds on place, energy and events, and the closed forms.
#include "physics/flight.h"
#include "physics/fold.h"
#include "physics/time_of_impact.h"
#include "tests/physics/random_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace hyrax;
using namespace hyrax::test;

namespace {

// A year: more uptime than any desktop has.
constexpr Ticks latest = 365 * 24 * 3600 * ticks_per_second;

bool is_inward(const BodyState& state, ContactKind kind) {
    switch (kind) {
        case ContactKind::left_wall:
            return state.velocity.x >= 0.0;
        case ContactKind::right_wall:
            return state.velocity.x <= 0.0;
        case ContactKind::ceiling:
            return state.velocity.y >= 0.0;
        case ContactKind::floor:
            return state.velocity.y <= 0.0;
        case ContactKind::edge:
            return state.velocity.y == 0.0 && state.mode == Mode::air;
        case ContactKind::stop:
            return state.velocity == Vec2{} && state.mode == Mode::rest;
        case ContactKind::none:
            break;
    }
    return false;
}

// One throw between two walls without gravity, bounce by bounce, in the stopping-distance variable.
FoldedMotion bounce_by_bounce(
    double position, double velocity, Support walls, double restitution, double drag, double t
) {
    double left = drag == 0.0 ? t : -std::expm1(-drag * t) / drag;
    double speed = velocity;
    double bounces = 0.0;
    while (speed != 0.0) {
        const double wall = speed > 0.0 ? walls.right : walls.left;
        const double until = (wall - position) / speed;
        if (until > left) {
            break;
        }
        left -= until;
        position = wall;
        speed *= -restitution;
        bounces += 1.0;
    }
    return {position + speed * left, speed * std::exp(-drag * t), bounces};
}

}  // namespace

TEST_CASE("containment: at every read, the ticks around each event included") {
    double deepest = 0.0;
    int reads = 0;
    int beyond = 0;
    for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Scene scene = random_scene(random);
        Run run(scene, random.one_in(2) ? WallEvents::wanted : WallEvents::not_wanted);
        Ticks now = 0;
        const auto read = [&](Ticks time) {
            if (time < now) {
                return;
            }
            now = time;
            CAPTURE(now);
            const BodyState state = run.at(now);
            const double depth = depth_inside(scene.space, state.position);
            CHECK(depth <= 1e-9);
            CHECK(run.body().position(now, scene.law, scene.space) == state.position);
            deepest = std::max(deepest, depth);
            beyond += depth > 0.0 ? 1 : 0;
            ++reads;
        };
        for (int event = 0; event < 60 && run.body().next_event() < latest; ++event) {
            const Ticks due = run.body().next_event();
            read(now + (due - now) / 3);
            read(due - 1);
            read(due);
            read(due + 1);
        }
        read(now + ticks_per_second);
    }
    MESSAGE(reads, " reads, ", beyond, " beyond a side, deepest ", deepest, " px");
    // Sides that are met are not passed by a rounding. An apex on a ceiling may be.
    CHECK(beyond <= reads / 10'000);
}

TEST_CASE("energy never grows, whatever is met") {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Scene scene = random_scene(random);
        Run run(scene);
        double before = energy(run.at(0), scene.law);
        // The height counts from the origin: the scale of what may be lost in rounding.
        const double scale = std::fabs(before) + 0.5 * scene.velocity.x * scene.velocity.x +
                             0.5 * scene.velocity.y * scene.velocity.y + scene.law.gravity * 5000.0;
        Ticks now = 0;
        for (int read = 0; read < 100; ++read) {
            now += random.ticks(ticks_per_second / 10);
            const double after = energy(run.at(now), scene.law);
            worst = std::max(worst, (after - before) / scale);
            CHECK(after - before <= 1e-12 * scale);
            before = after;
        }
    }
    MESSAGE("greatest gain ", worst, " of the whole");
}

TEST_CASE("energy is kept to 1e-10 over a million frames without losses") {
    const Scene scene{
        elastic_law(1200.0), FreeSpace::box(0.0, 0.0, 1792.0, 952.0), {100.0, 50.0}, {700.0, 0.0}
    };
    Run run(scene);
    const double before = energy(run.at(0), scene.law) + scene.law.gravity * 952.0;
    double worst = 0.0;
    for (Ticks frame = 1; frame <= 1'000'000; ++frame) {
        const double now = energy(run.at(frame * ticks_per_second / 60), scene.law);
        worst = std::max(worst, std::fabs(now + scene.law.gravity * 952.0 - before) / before);
    }
    MESSAGE(run.events.size(), " events, worst ", worst);
    CHECK(worst <= 1e-10);
    CHECK(run.events.size() > 10'000);
}

TEST_CASE("events come in order, and turn the body inwards") {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Scene scene = random_scene(random);
        Run run(scene);
        Ticks last = 0;
        for (int i = 0; i < 60 && run.body().next_event() < latest; ++i) {
            const Ticks due = run.body().next_event();
            run.events.clear();
            const BodyState state = run.at(due);
            REQUIRE(!run.events.empty());
            for (const TrajectoryEvent& event : run.events) {
                CHECK(event.time >= last);
                CHECK(event.time <= due);
                CHECK(event.time >= due - 1);
                CHECK(event.speed >= 0.0);
                last = event.time;
            }
            if (run.body().next_event() > due + 1 && run.events.size() == 1 &&
                run.body().mode() != Mode::air) {
                CHECK(is_inward(state, run.events.front().kind));
            }
        }
    }
}

TEST_CASE("after its contact a body no longer moves towards what it met") {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Scene scene = random_scene(random);
        BodyState state = let_go(scene.position, scene.velocity, scene.law, scene.space);
        for (int i = 0; i < 60; ++i) {
            const Contact contact = next_contact(state, scene.law, scene.space);
            if (contact.time == infinity) {
                break;
            }
            CHECK(contact.time >= 0.0);
            const BodyState arriving = free_motion(state, scene.law, contact.time);
            state = after_contact(contact, arriving, scene.law, scene.space);
            CHECK(is_inward(state, contact.kind));
        }
    }
}

TEST_CASE("a throw has no more bounces and takes no longer than its speed allows") {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Scene scene = random_scene(random, true);
        scene.law.gravity = random.pick({300.0, 1200.0, 9000.0, 1e6});
        scene.law.drag = 0.0;
        scene.law.ground_drag = random.pick({0.5, 13.4});
        scene.law.restitution = random.pick({0.0, 0.3, 0.6, 0.9});
        scene.law.rest_speed = std::max(5.0, std::sqrt(2.0 * scene.law.gravity * visible_hop));
        const Law& law = scene.law;
        const double beta = law.restitution;
        const double height = scene.space.obstacles()[3].top - scene.space.obstacles()[2].bottom;
        const double width = scene.space.obstacles()[1].left - scene.space.obstacles()[0].right;
        const double rise = std::fabs(scene.velocity.y);
        const double impact = std::sqrt(rise * rise + 2.0 * law.gravity * height);
        // The first fall, all hops as a geometric series, and the slide.
        const double bound =
            2.0 * (rise + impact) / law.gravity + 2.0 * impact * beta / law.gravity / (1.0 - beta) +
            std::log(std::max(1.0, std::fabs(scene.velocity.x) / law.stop_speed)) / law.ground_drag;
        Run run(scene);
        const BodyState state = run.at(from_seconds(bound) + 1);
        CHECK(state.mode == Mode::rest);
        const double floors =
            beta == 0.0 ? 1.0 : 2.0 + std::log(impact / law.rest_speed) / std::log(1.0 / beta);
        const double walls = 1.0 + std::fabs(scene.velocity.x) * bound / width;
        const auto hits =
            std::ranges::count(run.events, ContactKind::floor, &TrajectoryEvent::kind);
        CHECK(static_cast<double>(hits) <= std::max(1.0, floors));
        // A floor, a ceiling before the first of them, and one stop.
        CHECK(static_cast<double>(run.events.size()) <= std::max(1.0, floors) + walls + 2.0);
    }
}

TEST_CASE("a hop returns with gravity times its time minus the speed it left with") {
    for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const double gravity = random.scale(1.0, 1e6);
        const double speed = random.scale(1.0, 1e5);
        const double drag = random.scale(1e-14, 1e3) * gravity / speed;
        const double time = fall_time(0.0, -speed, gravity, drag);
        const AxisState landing = fly(-speed, gravity, drag, time);
        CHECK(std::fabs(landing.offset) <= 1e-14 * speed * time);
        // Either side may be the small difference of the other's terms.
        CHECK(
            std::fabs(landing.velocity - (gravity * time - speed)) <=
            1e-14 * (gravity * time + speed)
        );
    }
}

TEST_CASE("between walls the way is a straight line in the stopping distance") {
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Scene scene = random_scene(random, true);
        scene.law = law_from({});
        scene.law.drag = random.scale(1e-3, 3.0);
        scene.law.impact_friction = 1.0;
        scene.law.ground_drag = scene.law.drag;
        scene.law.stop_speed = 0.0;
        const double drag = scene.law.drag;
        Run run(scene);
        for (int read = 0; read < 40; ++read) {
            const Ticks now = read * 100'000'000LL;
            const BodyState state = run.at(now);
            const auto walls = std::ranges::count_if(run.events, [](const TrajectoryEvent& event) {
                return event.kind == ContactKind::left_wall ||
                       event.kind == ContactKind::right_wall;
            });
            const double slope = state.velocity.x * std::exp(drag * to_seconds(now));
            const double expected =
                scene.velocity.x * std::pow(-scene.law.restitution, static_cast<double>(walls));
            CHECK(std::fabs(slope - expected) <= 1e-11 * std::fabs(expected));
        }
    }
}

TEST_CASE("fold: as bounce by bounce, with the same number of bounces") {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 20'000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const double left = random.between(-4000.0, 4000.0);
        const double width = random.scale(0.1, 4000.0);
        const Support walls{left, left + width};
        const double position = random.between(walls.left, walls.right);
        const double speed = random.scale(1.0, 1e5);
        const double velocity = random.one_in(2) ? speed : -speed;
        const double restitution = random.pick({0.0, 0.1, 0.6, 0.9, 0.99, 1.0 - 1e-9, 1.0});
        const double drag = random.pick({0.0, 1e-9, 0.06, 1.0, 30.0});
        const double t = std::min(random.scale(1e-3, 60.0), 3000.0 * width / speed);
        const FoldedMotion events =
            bounce_by_bounce(position, velocity, walls, restitution, drag, t);
        const FoldedMotion folded = fold(position, velocity, walls, restitution, drag, t);
        const double miss = std::fabs(folded.position - events.position) / std::max(width, 1.0);
        worst = std::max(worst, miss);
        CHECK(folded.bounces == events.bounces);
        CHECK(miss <= 1e-9);
        CHECK(
            std::fabs(folded.velocity - events.velocity) <=
            1e-9 * std::fabs(events.velocity) + 1e-15 * speed
        );
    }
    MESSAGE("worst ", worst, " of the width");
}

TEST_CASE("a body too quick to be followed is folded to where its bounces would lead it") {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Scene scene = random_scene(random, true);
        scene.velocity = random_velocity(random, 1e4, 1e6);
        Run bouncing(scene);
        Run folded(scene, WallEvents::not_wanted);
        for (int read = 0; read < 20; ++read) {
            const Ticks now = read * 20'000'000LL;
            const BodyState expected = bouncing.at(now);
            const BodyState state = folded.at(now);
            const double miss = distance(state.position, expected.position);
            worst = std::max(worst, miss);
            CHECK(miss <= 1e-6);
            CHECK(state.mode == expected.mode);
        }
    }
    MESSAGE("worst ", worst, " px");
}

TEST_CASE("a train of hops without drag is the geometric series, Zeno's point included") {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Law law = elastic_law(random.scale(10.0, 1e5));
        law.restitution = random.between(0.05, 0.97);
        law.impact_friction = random.between(0.3, 1.0);
        law.rest_speed = 1e-6;
        const double speed = random.scale(10.0, 3000.0);
        const double beta = law.restitution;
        const double first = 2.0 * speed / law.gravity;
        const Vec2 velocity{random.between(-100.0, 100.0), -speed};
        const FreeSpace space(std::vector{Obstacle{.top = 100.0}});
        const Scene scene{law, space, {0.0, 100.0}, velocity};
        Run run(scene);
        const double t = random.between(0.0, 1.2) * first / (1.0 - beta);
        const BodyState state = run.at(from_seconds(t));
        const double time = to_seconds(from_seconds(t));
        // Hops of a speed below rest_speed do not take place.
        const double most = 1.0 + std::floor(std::log(law.rest_speed / speed) / std::log(beta));
        const double share = time * (1.0 - beta) / first;
        const double hops =
            share < 1.0 ? std::min(most, std::floor(std::log1p(-share) / std::log(beta))) : most;
        CAPTURE(hops);
        CHECK(
            std::fabs(static_cast<double>(run.events.size()) - hops) <= (share < 1.0 ? 0.0 : 1.0)
        );
        const double since = time - first * (1.0 - std::pow(beta, hops)) / (1.0 - beta);
        const double height =
            hops < most ? since * (speed * std::pow(beta, hops) - 0.5 * law.gravity * since) : 0.0;
        const double miss = std::fabs((100.0 - state.position.y) - height);
        const double highest = 0.5 * speed * speed / law.gravity;
        worst = std::max(worst, miss / (highest + 100.0));
        CHECK(miss <= 1e-9 * (highest + 100.0));
    }
    MESSAGE("worst ", worst);
}
