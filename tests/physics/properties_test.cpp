// SPDX-License-Identifier: MIT
// What must hold for every trajectory: independence of the reads, and the symmetries of the law.
#include "physics/steppers.h"
#include "tests/physics/random_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace hyrax;
using namespace hyrax::test;

namespace {

std::vector<Ticks> random_partition(Random& random, Ticks end) {
    std::vector<Ticks> cuts(random.below(200));
    for (Ticks& cut : cuts) {
        cut = random.ticks(end);
    }
    std::ranges::sort(cuts);
    return cuts;
}

// A stretch of motion without ticks: the law alone.
std::vector<BodyState> states_after_contacts(const Scene& scene, int most) {
    std::vector<BodyState> states{let_go(scene.position, scene.velocity, scene.law, scene.space)};
    for (int i = 0; i < most; ++i) {
        const BodyState& state = states.back();
        const Contact contact = next_contact(state, scene.law, scene.space);
        if (contact.kind == ContactKind::none || contact.time == infinity) {
            break;
        }
        const BodyState arriving = free_motion(state, scene.law, contact.time);
        states.push_back(after_contact(contact, arriving, scene.law, scene.space));
    }
    return states;
}

Scene mirrored(Scene scene) {
    std::vector<Obstacle> obstacles;
    for (const Obstacle& o : scene.space.obstacles()) {
        obstacles.push_back({-o.right, o.top, -o.left, o.bottom});
    }
    scene.space = FreeSpace(std::move(obstacles));
    scene.position.x = -scene.position.x;
    scene.velocity.x = -scene.velocity.x;
    return scene;
}

Scene moved(Scene scene, Vec2 by) {
    std::vector<Obstacle> obstacles;
    for (const Obstacle& o : scene.space.obstacles()) {
        obstacles.push_back({o.left + by.x, o.top + by.y, o.right + by.x, o.bottom + by.y});
    }
    scene.space = FreeSpace(std::move(obstacles));
    scene.position = scene.position + by;
    return scene;
}

// Lengths by one factor, times by another.
Scene scaled(Scene scene, double length, double time) {
    std::vector<Obstacle> obstacles;
    for (const Obstacle& o : scene.space.obstacles()) {
        obstacles.push_back({o.left * length, o.top * length, o.right * length, o.bottom * length});
    }
    scene.space = FreeSpace(std::move(obstacles));
    scene.position = scene.position * length;
    scene.velocity = scene.velocity * (length / time);
    scene.law.gravity *= length / time / time;
    scene.law.rest_speed *= length / time;
    scene.law.stop_speed *= length / time;
    scene.law.drag /= time;
    scene.law.ground_drag /= time;
    return scene;
}

std::ptrdiff_t ceilings(const Run& run) {
    return std::ranges::count(run.events, ContactKind::ceiling, &TrajectoryEvent::kind);
}

BodyState mirrored(BodyState state) {
    // Plus zero: a body without horizontal velocity has none in the mirror either.
    state.position.x = -state.position.x + 0.0;
    state.velocity.x = -state.velocity.x + 0.0;
    return state;
}

}  // namespace

TEST_CASE("sampling independence: no set of reads changes a bit of a later one") {
    int given_up = 0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Scene scene = random_scene(random);
        const WallEvents walls = random.one_in(2) ? WallEvents::wanted : WallEvents::not_wanted;
        const Ticks end = random.ticks(10 * ticks_per_second);
        Run once(scene, walls);
        const BodyState expected = once.at(end);
        // What is given up depends on how much there is to do in one go.
        if (once.events.size() >= Trajectory::most_events) {
            ++given_up;
            continue;
        }
        Run often(scene, walls);
        for (const Ticks cut : random_partition(random, end)) {
            often.at(cut);
        }
        CHECK(same_bits(often.at(end), expected));
        CHECK(often.events.size() == once.events.size());
    }
    CHECK(given_up <= 5);
}

TEST_CASE("sampling independence: exact steps from frame to frame, to 1e-9 px") {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Scene scene = random_scene(random);
        const Ticks end = random.ticks(4 * ticks_per_second);
        Run exact(scene);
        std::vector<Impact> impacts;
        BodyState state = let_go(scene.position, scene.velocity, scene.law, scene.space);
        Ticks now = 0;
        std::vector<Ticks> cuts = random_partition(random, end);
        cuts.push_back(end);
        for (const Ticks cut : cuts) {
            state = step_exponential_swept(
                state, scene.law, scene.space, to_seconds(cut - now), impacts
            );
            now = cut;
        }
        const double miss = distance(state.position, exact.at(end).position);
        worst = std::max(worst, miss);
        CHECK(miss <= 1e-9);
    }
    MESSAGE("worst ", worst, " px");
}

TEST_CASE("semigroup: to go on from a state that was read is to go on, to 1e-10 px") {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Scene scene = random_scene(random);
        const Ticks first = random.ticks(3 * ticks_per_second);
        const Ticks second = random.ticks(3 * ticks_per_second);
        Run whole(scene);
        const BodyState between = whole.at(first);
        const BodyState expected = whole.at(first + second);
        scene.position = between.position;
        scene.velocity = between.velocity;
        Run rest(scene);
        const double miss = distance(rest.at(second).position, expected.position);
        worst = std::max(worst, miss);
        // Roundings of the time add up from bounce to bounce, and are worth their speed.
        const double bounces = std::max(1.0, static_cast<double>(whole.events.size()) / 100.0);
        const double speed = std::hypot(expected.velocity.x, expected.velocity.y);
        CHECK(miss <= 1e-10 * bounces * std::max(1.0, speed / 1000.0));
    }
    MESSAGE("worst ", worst, " px");
}

TEST_CASE("idempotence: to advance to the same moment again changes nothing") {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Scene scene = random_scene(random);
        Run run(scene);
        const Ticks now = random.ticks(5 * ticks_per_second);
        const BodyState once = run.at(now);
        const std::size_t events = run.events.size();
        CHECK(same_bits(run.at(now), once));
        CHECK(run.events.size() == events);
        std::vector<Impact> impacts;
        CHECK(same_bits(step_exponential_swept(once, scene.law, scene.space, 0.0, impacts), once));
    }
}

TEST_CASE("rest is absorbing: no time and no number of reads moves a body at rest") {
    int rested = 0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Scene scene = random_scene(random);
        Run run(scene);
        const BodyState state = run.at(60 * ticks_per_second);
        if (state.mode != Mode::rest) {
            continue;
        }
        ++rested;
        CHECK(run.body().next_event() == never);
        CHECK(state.velocity == Vec2{});
        const std::size_t events = run.events.size();
        for (Ticks later = 1; later < 365 * 24 * 3600 * ticks_per_second; later *= 7) {
            CHECK(same_bits(run.at(60 * ticks_per_second + later), state));
        }
        CHECK(run.events.size() == events);
    }
    CHECK(rested > 250);
}

TEST_CASE("time reversal: without losses every motion leads back to where it began") {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Scene scene = random_scene(random);
        scene.law = elastic_law(random.pick({0.0, 300.0, 1200.0, 9000.0}));
        scene.velocity = random_velocity(random, 100.0, 5000.0);
        const Vec2 start = scene.position;
        const Ticks span = random.ticks(20 * ticks_per_second);
        Run forth(scene);
        const BodyState turned = forth.at(span);
        Scene reversed = scene;
        reversed.position = turned.position;
        reversed.velocity = turned.velocity * -1.0;
        Run back(reversed);
        const double miss = distance(back.at(span).position, start);
        worst = std::max(worst, miss);
        CHECK(miss <= 1e-9);
    }
    MESSAGE("worst ", worst, " px");
}

TEST_CASE("mirror: left and right are alike, to the bit") {
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Scene scene = random_scene(random);
        const Scene image = mirrored(scene);
        Run run(scene);
        Run other(image);
        for (int read = 0; read < 10; ++read) {
            const Ticks now = read * 333'333'333LL;
            BodyState state = run.at(now);
            state.velocity.x += 0.0;
            CHECK(same_bits(mirrored(other.at(now)), state));
        }
    }
}

TEST_CASE("translation: a shift that keeps the spacing of doubles keeps the bits, any other 1e-9") {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Scene scene = random_scene(random);
        // Between 2^20 and 2^21 all doubles lie on one grid.
        constexpr double far = 0x1.8p20;
        constexpr Vec2 dyadic{8192.0, -16384.0};
        const Vec2 shift{random.between(-4000.0, 4000.0), random.between(-4000.0, 4000.0)};
        const Scene on_grid = moved(scene, {std::floor(far), std::floor(far)});
        const Scene shifted = moved(on_grid, dyadic);
        const Scene elsewhere = moved(scene, shift);
        Run here(on_grid);
        Run there(shifted);
        Run plain(scene);
        Run free(elsewhere);
        for (int read = 0; read < 10; ++read) {
            const Ticks now = read * 333'333'333LL;
            BodyState back = there.at(now);
            back.position = back.position - dyadic;
            CHECK(same_bits(here.at(now), back));
            const double miss = distance(plain.at(now).position + shift, free.at(now).position);
            worst = std::max(worst, miss);
            CHECK(miss <= 1e-9);
        }
    }
    MESSAGE("worst ", worst, " px");
}

TEST_CASE("scaling: lengths by a power of two, to the bit") {
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Scene scene = random_scene(random);
        const double factor = std::ldexp(1.0, random.whole(-12, 12));
        const Scene larger = scaled(scene, factor, 1.0);
        Run run(scene);
        Run other(larger);
        for (int read = 0; read < 10; ++read) {
            const Ticks now = read * 333'333'333LL;
            BodyState state = run.at(now);
            state.position = state.position * factor;
            state.velocity = state.velocity * factor;
            CHECK(same_bits(other.at(now), state));
        }
        CHECK(other.events.size() == run.events.size());
    }
}

TEST_CASE("scaling: times by a power of two, to the bit for the law, to 1e-9 px in ticks") {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Scene scene = random_scene(random);
        const int power = random.whole(1, 6);
        const double factor = std::ldexp(1.0, power);
        const Scene slower = scaled(scene, 1.0, factor);
        const std::vector<BodyState> quick = states_after_contacts(scene, 30);
        const std::vector<BodyState> slow = states_after_contacts(slower, 30);
        REQUIRE(quick.size() == slow.size());
        for (std::size_t i = 0; i < quick.size(); ++i) {
            BodyState state = slow[i];
            state.velocity = state.velocity * factor;
            CHECK(same_bits(state, quick[i]));
        }
        Run run(scene);
        Run other(slower);
        const Ticks now = random.ticks(4 * ticks_per_second);
        const double miss = distance(run.at(now).position, other.at(now << power).position);
        worst = std::max(worst, miss);
        CHECK(miss <= 1e-9);
    }
    MESSAGE("worst ", worst, " px");
}

TEST_CASE("axis decoupling: in a box, what goes on sideways does not change the height") {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Scene scene = random_scene(random, true);
        // Without gravity drag stops a body by its speed in both directions.
        if (scene.law.gravity == 0.0) {
            scene.law.drag = 0.0;
        }
        Run run(scene);
        Scene other = scene;
        other.velocity.x = random.between(-3000.0, 3000.0);
        other.position.x = random_place(random, scene.space).x;
        Run sideways(other);
        for (int read = 0; read < 10; ++read) {
            const Ticks now = read * 333'333'333LL;
            const double miss = std::fabs(run.at(now).position.y - sideways.at(now).position.y);
            // An apex on the ceiling itself: a rounding decides whether it is met.
            const bool grazes = ceilings(run) != ceilings(sideways);
            CHECK(miss <= (grazes ? 1e-4 : 1e-9));
            worst = std::max(worst, grazes ? 0.0 : miss);
        }
    }
    MESSAGE("worst ", worst, " px");
}
