// SPDX-License-Identifier: MIT
// The same motion with every compiler, every optimisation and every C library.
#include "tests/physics/random_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace hyrax;
using namespace hyrax::test;

namespace {

// Functions of the library that are off by a rounding move a body by some 1e-12 px.
constexpr double quantum = 1e-9;

// Of scenes in which no place lies near the middle between two values.
constexpr std::uint64_t golden_seed = 34200;

// What a scene does is given by sums, products and roots alone, without a function of the library.
Scene scene_without_library(Random& random) {
    Scene scene;
    scene.law = {
        .gravity = random.pick({300.0, 1200.0, 9000.0}),
        .restitution = random.pick({0.25, 0.5, 0.75, 1.0}),
        .impact_friction = random.pick({0.5, 0.75, 1.0}),
        .rest_speed = 15.0,
        .stop_speed = 5.0,
    };
    scene.space = random.one_in(2) ? random_box(random) : random_arena(random);
    scene.position = scene.space.nearest(
        {std::floor(random.between(-3000.0, 3000.0)), std::floor(random.between(-3000.0, 3000.0))}
    );
    scene.velocity = {random.between(-3000.0, 3000.0), random.between(-3000.0, 3000.0)};
    return scene;
}

Scene scene_of_the_document(Random& random) {
    Scene scene = scene_without_library(random);
    scene.law = law_from({});
    return scene;
}

void add(Hash& hash, const BodyState& state) {
    hash.add(state.position.x);
    hash.add(state.position.y);
    hash.add(state.velocity.x);
    hash.add(state.velocity.y);
    hash.add(static_cast<std::uint64_t>(state.mode));
}

// Rounds, and tells how near to the next value that would have been rounded otherwise.
std::int64_t rounded(double value, double& margin) {
    const double steps = value / quantum;
    const double whole = std::floor(steps);
    margin = std::min(margin, std::fabs(steps - whole - 0.5));
    return static_cast<std::int64_t>(whole + (steps - whole >= 0.5 ? 1.0 : 0.0));
}

}  // namespace

TEST_CASE("golden hash: without drag, to the bit") {
    Hash hash;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        Random random(seed);
        Run run(scene_without_library(random));
        for (int read = 0; read < 40; ++read) {
            add(hash, run.at(read * 123'456'789LL));
        }
        for (const TrajectoryEvent& event : run.events) {
            hash.add(static_cast<std::uint64_t>(event.time));
            hash.add(static_cast<std::uint64_t>(event.kind));
            hash.add(event.speed);
        }
    }
    CHECK(hash.value() == 0xacf9d7957cd7fbdd);
}

TEST_CASE("golden hash: the document's law, to 1e-9 px") {
    Hash hash;
    double margin = 0.5;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Random random(seed + golden_seed);
        Run run(scene_of_the_document(random));
        for (const Ticks now : {700'000'000LL, 2'100'000'000LL, 60'000'000'000LL}) {
            const BodyState state = run.at(now);
            hash.add(static_cast<std::uint64_t>(rounded(state.position.x, margin)));
            hash.add(static_cast<std::uint64_t>(rounded(state.position.y, margin)));
            hash.add(static_cast<std::uint64_t>(state.mode));
        }
        const std::uint64_t events = run.events.size();
        hash.add(events);
    }
    // No place is so near to the middle between two values that another library rounds it there.
    CHECK(margin * quantum >= 1e-11);
    CHECK(hash.value() == 0xd60659757b31a41f);
}
