// SPDX-License-Identifier: MIT
// Bodies on desktops of several monitors: never outside, never lost, and no seam is felt.
#include "tests/physics/layouts.h"
#include "tests/physics/random_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace hyrax;
using namespace hyrax::test;

namespace {

// In all, over all layouts.
constexpr int random_ticks = 1'000'000;

// What a body of these sizes shows on screen: a pinned one only the part that fits.
Vec2 shown_size(const FreeSpace& space, Size box) {
    return {box.width - 2.0 * space.overhang().x, box.height - 2.0 * space.overhang().y};
}

Ticks random_step(Random& random) {
    switch (random.below(4)) {
        case 0:
            return random.ticks(1000);
        case 1:
            return random.ticks(ticks_per_second);
        default:
            return random.ticks(ticks_per_second / 30);
    }
}

struct Wandering {
    int ticks = 0;
    int throws = 0;
    std::size_t most_events = 0;  // In one tick, of the document's law.
    int outside = 0;
    int resting_nowhere = 0;
};

// Pets with one law each, thrown anew when they rest.
void wander(const Layout& layout, std::uint64_t seed, int ticks, Wandering& all) {
    Random random(seed);
    const FreeSpace space = FreeSpace::among(layout.rooms, layout.box);
    const Vec2 size = shown_size(space, layout.box);
    const std::vector<Rect> rooms = all_rooms(layout);
    const Law law = random_law(random);
    Trajectory body;
    Ticks now = random.ticks(1'000'000 * ticks_per_second);
    const auto launch = [&](Vec2 from) {
        const Vec2 velocity = random_velocity(random, 1.0, 1e4);
        const WallEvents walls = random.one_in(2) ? WallEvents::wanted : WallEvents::not_wanted;
        body.launch(now, from, velocity, law, space, walls);
        ++all.throws;
    };
    launch(random_place(random, space));
    for (int tick = 0; tick < ticks; ++tick) {
        now += random_step(random);
        std::size_t events = 0;
        body.advance(now, law, space, [&](const TrajectoryEvent&) { ++events; });
        const BodyState state = body.at(now, law, space);
        if (law == law_from({})) {
            all.most_events = std::max(all.most_events, events);
        }
        all.outside += covered(rooms, state.position, size) ? 0 : 1;
        const bool lies = law.gravity == 0.0 || space.support(state.position).has_value();
        all.resting_nowhere += state.mode == Mode::rest && !lies ? 1 : 0;
        if (state.mode == Mode::rest || random.one_in(200)) {
            launch(random.one_in(4) ? random_place(random, space) : state.position);
        }
    }
    all.ticks += ticks;
}

// Steps that are so small that nothing needs to be located; impacts by looking where the box is.
class TinySteps {
public:
    TinySteps(std::vector<Rect> rooms, Vec2 size, const Law& law, Vec2 position, Vec2 velocity)
        : rooms_(std::move(rooms)),
          size_(size),
          law_(law),
          position_(position),
          velocity_(velocity) {}

    void step(double dt) {
        if (!on_ground_) {
            velocity_.y += law_.gravity * dt;
        }
        const double drag = on_ground_ ? law_.ground_drag : law_.drag;
        velocity_ = velocity_ * (1.0 - drag * dt);
        const Vec2 sideways{position_.x + velocity_.x * dt, position_.y};
        if (covered(rooms_, sideways, size_)) {
            position_ = sideways;
        } else {
            velocity_.x *= -law_.restitution;
        }
        const Vec2 level{position_.x, position_.y + (on_ground_ ? 1e-6 : velocity_.y * dt)};
        if (covered(rooms_, level, size_)) {
            position_.y = on_ground_ ? position_.y : level.y;
            on_ground_ = false;
        } else if (!on_ground_) {
            bounce();
        }
        if (on_ground_ && std::fabs(velocity_.x) <= law_.stop_speed) {
            velocity_.x = 0.0;
        }
    }
    Vec2 position() const { return position_; }

private:
    void bounce() {
        const bool falls = velocity_.y > 0.0;
        velocity_.y *= -law_.restitution;
        if (falls) {
            velocity_.x *= law_.impact_friction;
            if (-velocity_.y < law_.rest_speed) {
                velocity_.y = 0.0;
                on_ground_ = true;
            }
        }
    }

    std::vector<Rect> rooms_;
    Vec2 size_;
    Law law_;
    Vec2 position_;
    Vec2 velocity_;
    bool on_ground_ = false;
};

}  // namespace

TEST_CASE("every body stays on the monitors, whatever happens") {
    const std::vector<Layout> all = layouts();
    CHECK(all.size() >= 20);
    constexpr int laws = 40;
    const int ticks = random_ticks / laws / static_cast<int>(all.size()) + 1;
    int total = 0;
    for (const Layout& layout : all) {
        CAPTURE(layout.name);
        Wandering wandering;
        for (std::uint64_t seed = 1; seed <= laws; ++seed) {
            const int outside = wandering.outside;
            wander(layout, seed, ticks, wandering);
            CAPTURE(seed);
            CHECK(wandering.outside == outside);
        }
        CHECK(wandering.resting_nowhere == 0);
        // In a second at most: all hops of a throw, and its walls.
        CHECK(wandering.most_events <= 60);
        total += wandering.ticks;
    }
    CHECK(total >= random_ticks);
}

TEST_CASE("tiny steps that look where the box is lead to the same places") {
    double worst = 0.0;
    int compared = 0;
    for (const Layout& layout : layouts()) {
        if (layout.rooms.size() > 3) {
            continue;
        }
        CAPTURE(layout.name);
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            CAPTURE(seed);
            Random random(seed);
            const FreeSpace space = FreeSpace::among(layout.rooms, layout.box);
            Scene scene{law_from({}), space, random_place(random, space), {}};
            scene.velocity = random_velocity(random, 300.0, 1500.0);
            Run exact(scene);
            TinySteps tiny(
                all_rooms(layout),
                shown_size(space, layout.box),
                scene.law,
                scene.position,
                scene.velocity
            );
            constexpr int steps_per_second = 10'000;
            for (int step = 1; step <= 2 * steps_per_second; ++step) {
                tiny.step(1.0 / steps_per_second);
                if (step % (steps_per_second / 4) == 0) {
                    const Ticks now = ticks_per_second / steps_per_second * step;
                    const double miss = distance(exact.at(now).position, tiny.position());
                    worst = std::max(worst, miss);
                    ++compared;
                    CHECK(miss <= 1.5);
                }
            }
        }
    }
    MESSAGE(compared, " places, worst ", worst, " px");
}

TEST_CASE("a seam between monitors is never felt: the bits are those of one large monitor") {
    const Size pet{128, 96};
    const FreeSpace one = FreeSpace::among({{0, 0, 3840, 2120}}, pet);
    // The lower left is no monitor; above and beside it, one desktop.
    const FreeSpace seams = FreeSpace::among(
        {{0, 0, 1920, 1040}, {1920, 0, 1920, 1040}, {1920, 1040, 1920, 1080}}, pet
    );
    int compared = 0;
    int crossings = 0;
    for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Law law = random_law(random);
        const Vec2 from = seams.nearest({random.between(0.0, 3800.0), random.between(0.0, 2000.0)});
        const Vec2 velocity = random_velocity(random, 100.0, 5000.0);
        const Scene with{law, seams, from, velocity};
        const Scene without{law, one, from, velocity};
        Run across(with);
        Run plain(without);
        for (int read = 0; read < 60; ++read) {
            const Ticks now = read * 50'000'000LL;
            const BodyState expected = plain.at(now);
            // Near the pillar the two desktops differ.
            if (expected.position.x < 2300.0 && expected.position.y > 600.0) {
                break;
            }
            crossings += std::fabs(expected.position.x - 1856.0) < 64.0 ? 1 : 0;
            ++compared;
            CHECK(same_bits(across.at(now), expected));
        }
    }
    MESSAGE(compared, " places, ", crossings, " of them across the seam");
    CHECK(crossings > 300);
}

TEST_CASE("a body slides from monitor to monitor, and off the end of the higher floor") {
    const Size pet{100, 100};
    const FreeSpace space =
        FreeSpace::among({{0, 0, 1000, 1000}, {1000, 0, 1000, 1000}, {2000, 0, 1000, 1300}}, pet);
    Scene scene{law_from({}), space, {700.0, 900.0}, {1000.0, 0.0}};
    scene.law.ground_drag = 0.0;
    Run run(scene);
    CHECK(run.at(ticks_per_second).position == Vec2{1700.0, 900.0});
    CHECK(run.body().mode() == Mode::ground);
    CHECK(run.events.empty());
    const BodyState off = run.at(from_seconds(1.301));
    CHECK(off.mode == Mode::air);
    REQUIRE(run.events.size() == 1);
    CHECK(run.events.front().kind == ContactKind::edge);
    CHECK(run.events.front().time == from_seconds(1.3));
    CHECK(run.at(60 * ticks_per_second).position.y == 1200.0);
}

TEST_CASE("a pet larger than every monitor is pinned to the largest, its middle in the middle") {
    const FreeSpace wide = FreeSpace::among({{0, 0, 200, 900}, {-300, 0, 300, 200}}, {500, 100});
    CHECK(wide.overhang() == Vec2{0.0, 0.0});
    CHECK(wide.contains({-300.0, 50.0}));
    const FreeSpace wider = FreeSpace::among({{0, 0, 200, 900}, {-300, 0, 300, 200}}, {600, 100});
    CHECK(wider.overhang() == Vec2{200.0, 0.0});
    const FreeSpace huge = FreeSpace::among({{-50, 20, 200, 900}}, {4000, 3000});
    CHECK(huge.overhang() == Vec2{1900.0, 1050.0});
    CHECK(huge.nearest({5e300, -5e300}) == Vec2{-50.0, 20.0});
    const Scene scene{law_from({}), huge, {-50.0, 20.0}, {3000.0, -4000.0}};
    Run run(scene);
    for (int read = 0; read < 100; ++read) {
        CHECK(run.at(read * 10'000'000LL).position == Vec2{-50.0, 20.0});
    }
    CHECK(run.body().mode() == Mode::rest);
}
