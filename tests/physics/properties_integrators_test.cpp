// SPDX-License-Identifier: MIT
// The integrators against each other: two implementations of one law, orders of convergence,
// continuity in the constants, and what the document's scheme does to the energy.
#include "physics/runge_kutta.h"
#include "physics/steppers.h"
#include "tests/physics/random_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace hyrax;
using namespace hyrax::test;

namespace {

using Step = BodyState (*)(BodyState, const Law&, const FreeSpace&, double, std::vector<Impact>&);

BodyState stepped(const Scene& scene, Step step, int steps, double seconds) {
    std::vector<Impact> impacts;
    BodyState state = let_go(scene.position, scene.velocity, scene.law, scene.space);
    for (int i = 0; i < steps; ++i) {
        state = step(state, scene.law, scene.space, seconds / steps, impacts);
    }
    return state;
}

double miss_of(const Scene& scene, Step step, int steps, double seconds) {
    Run exact(scene);
    return distance(
        stepped(scene, step, steps, seconds).position, exact.at(from_seconds(seconds)).position
    );
}

// log2 of the factor by which steps half as long are better, in the mean over some doublings.
double order_of(const Scene& scene, Step step, int steps, double seconds) {
    constexpr int doublings = 4;
    const double coarse = miss_of(scene, step, steps, seconds);
    const double fine = miss_of(scene, step, steps << doublings, seconds);
    return std::log2(coarse / fine) / doublings;
}

Scene document_throw(Vec2 velocity) {
    return {law_from({}), FreeSpace::box(0.0, 0.0, 1792.0, 952.0), {100.0, 0.0}, velocity};
}

// Heights above the floor of the first two hops.
std::array<double, 2> peaks(const std::vector<double>& heights) {
    std::array<double, 2> found{};
    std::size_t count = 0;
    for (std::size_t i = 1; i + 1 < heights.size() && count < 2; ++i) {
        if (heights[i] > heights[i - 1] && heights[i] >= heights[i + 1]) {
            found.at(count++) = heights[i];
        }
    }
    return found;
}

}  // namespace

TEST_CASE("two implementations: a general solver with located impacts agrees to 1e-6 px") {
    double worst = 0.0;
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Scene scene = random_scene(random);
        scene.law = law_from({});
        scene.law.drag = random.pick({0.0, 0.06, 1.0, 5.0});
        scene.law.gravity = random.pick({0.0, 300.0, 1200.0, 9000.0});
        scene.velocity = random_velocity(random, 100.0, 3000.0);
        Run exact(scene);
        std::vector<Impact> impacts;
        BodyState state = let_go(scene.position, scene.velocity, scene.law, scene.space);
        double trial = 1.0 / 60.0;
        for (int frame = 1; frame <= 120; ++frame) {
            // Of a frame in whole ticks.
            constexpr Ticks length = ticks_per_second / 60;
            state = step_runge_kutta(
                state,
                scene.law,
                {},
                scene.space,
                {.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12},
                to_seconds(length),
                trial,
                impacts
            );
            const double miss = distance(state.position, exact.at(frame * length).position);
            ++compared;
            // Without gravity drag stops a body at the end of a step, by a frame of 5 px/s too
            // late.
            const bool floats = scene.law.gravity == 0.0 && scene.law.drag > 0.0;
            CHECK(miss <= (floats ? 5.0 / 60.0 : 1e-6));
            worst = std::max(worst, floats ? 0.0 : miss);
        }
    }
    MESSAGE(compared, " places, worst ", worst, " px");
}

TEST_CASE("two implementations: the document's class at 60 Hz has nearly the same hops and way") {
    // Dropped with 600 px/s sideways, no wall in reach.
    const Scene scene{
        law_from({}), FreeSpace::box(-1e5, -1e5, 1e5, 952.0), {0.0, 0.0}, {600.0, 0.0}
    };
    Run exact(scene);
    physics document(0.0, 0.0, 600.0, 0.0);
    std::vector<double> exact_heights;
    std::vector<double> document_heights;
    double end = 0.0;
    for (int frame = 1; frame <= 600; ++frame) {
        document.update(1.0 / 60.0, 1'000'000, 1080, 128, 128);
        document_heights.push_back(952.0 - document.y());
        const BodyState state = exact.at(from_seconds(frame / 60.0));
        exact_heights.push_back(952.0 - state.position.y);
        end = state.position.x;
    }
    const auto [first, second] = peaks(exact_heights);
    const auto [document_first, document_second] = peaks(document_heights);
    CHECK(std::fabs(first - 316.47) < 0.2);
    CHECK(std::fabs(end - 1859.474) < 1e-3);
    CHECK(std::fabs(document_first - first) <= 0.015 * first);
    CHECK(std::fabs(document_second - second) <= 0.06 * second);
    CHECK(std::fabs(document.x() - end) <= 40.0);
}

TEST_CASE("order of convergence in flight: 1 for Euler, 2 for Verlet, and exact steps are exact") {
    Scene flight = document_throw({600.0, -300.0});
    flight.law.drag = 1.5;
    CHECK(
        order_of(flight, step_semi_implicit_euler, 16, 0.7) == doctest::Approx(1.0).epsilon(0.05)
    );
    CHECK(order_of(flight, step_stormer_verlet, 16, 0.7) == doctest::Approx(2.0).epsilon(0.05));
    for (const int steps : {1, 7, 100, 1000}) {
        CHECK(miss_of(flight, step_exponential_swept, steps, 0.7) <= 1e-11);
    }
}

TEST_CASE("order of convergence through impacts: located ones keep it") {
    // Floor, wall and floor again, the last read well after it.
    Scene scene = document_throw({900.0, 500.0});
    scene.law.drag = 0.7;
    scene.law.impact_friction = 0.9;
    constexpr double seconds = 2.2;
    Run exact(scene);
    exact.at(from_seconds(seconds));
    CHECK(exact.events.size() >= 2);
    CHECK(order_of(scene, step_stormer_verlet, 64, seconds) == doctest::Approx(2.0).epsilon(0.15));
    const double euler = order_of(scene, step_semi_implicit_euler, 512, seconds);
    CHECK(euler > 0.6);
    CHECK(euler < 1.5);
    for (const int steps : {1, 7, 100, 1000}) {
        CHECK(miss_of(scene, step_exponential_swept, steps, seconds) <= 1e-10);
    }
}

TEST_CASE("the error of the adaptive solver follows its tolerance") {
    const Scene scene = document_throw({900.0, 500.0});
    Run run(scene);
    const Vec2 exact = run.at(2 * ticks_per_second).position;
    double before = infinity;
    for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
        CAPTURE(tolerance);
        std::vector<Impact> impacts;
        double trial = 0.1;
        const BodyState state = step_runge_kutta(
            let_go(scene.position, scene.velocity, scene.law, scene.space),
            scene.law,
            {},
            scene.space,
            {.relative_tolerance = tolerance, .absolute_tolerance = tolerance},
            2.0,
            trial,
            impacts
        );
        const double miss = distance(state.position, exact);
        CHECK(miss <= 1e4 * tolerance);
        CHECK(miss <= before + 1e-9);
        before = miss;
    }
}

TEST_CASE("without losses, located impacts keep the energy and the document's scheme does not") {
    Scene scene = document_throw({700.0, 0.0});
    scene.law = elastic_law(1200.0);
    // 10^5 frames of 60 Hz.
    const double whole = 0.5 * 700.0 * 700.0 + 1200.0 * 952.0;
    for (const Step step : {Step{step_exponential_swept}, Step{step_stormer_verlet}}) {
        const BodyState state = stepped(scene, step, 100'000, 100'000 / 60.0);
        CHECK(std::fabs(energy(state, scene.law) + 1200.0 * 952.0 - whole) <= 1e-10 * whole);
    }
    // One step of gravity, 20 px/s, is lost every two bounces.
    physics document(100.0, 300.3, 0.0, 3.3);
    document.setConstants(
        {.restitution = 1.0, .air_drag = 1.0, .ground_friction = 1.0, .rest_threshold = 0.0}
    );
    std::vector<double> rebounds;
    while (rebounds.size() < 21) {
        const double before = document.vy();
        document.update(1.0 / 60.0, 1920, 1080, 128, 128);
        if (before > 0.0 && document.vy() < 0.0) {
            rebounds.push_back(-document.vy());
        }
    }
    for (std::size_t i = 2; i < rebounds.size(); ++i) {
        CHECK(rebounds[i - 2] - rebounds[i] == doctest::Approx(20.0));
    }
}

TEST_CASE("continuity: nearly no drag, and nearly full restitution, are nearly none") {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Scene scene = random_scene(random);
        scene.law = law_from({});
        scene.law.drag = 0.0;
        scene.velocity = random_velocity(random, 100.0, 2000.0);
        Scene dragged = scene;
        dragged.law.drag = 1e-12;
        const Ticks now = random.ticks(5 * ticks_per_second);
        Run without(scene);
        Run with(dragged);
        const double miss = distance(without.at(now).position, with.at(now).position);
        worst = std::max(worst, miss);
        CHECK(miss <= 1e-6);

        scene.law = elastic_law(1200.0);
        Scene lossy = scene;
        lossy.law.restitution = 1.0 - 1e-12;
        Run full(scene);
        Run less(lossy);
        CHECK(distance(full.at(now).position, less.at(now).position) <= 1e-6);
    }
    MESSAGE("worst ", worst, " px");
}
