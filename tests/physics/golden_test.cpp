// SPDX-License-Identifier: MIT
// The event-driven integrator against solutions to 50 digits that share none of its formulas.
#include "physics/trajectory.h"
#include "tests/physics/references.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

using namespace hyrax;
using test::ReferenceSample;
using test::ReferenceScene;

namespace {

struct Outcome {
    double worst = 0.0;  // [px]
    int wrong_counts = 0;
    int wrong_modes = 0;
    int scenes = 0;
};

void compare(const ReferenceScene& scene, double bound, Outcome& outcome) {
    Trajectory body;
    body.launch(0, scene.position, scene.velocity, scene.law, scene.space);
    int events = 0;
    for (const ReferenceSample& sample : scene.samples) {
        body.advance(sample.time, scene.law, scene.space, [&](const TrajectoryEvent&) {
            ++events;
        });
        const BodyState state = body.at(sample.time, scene.law, scene.space);
        const Vec2 miss = state.position - sample.position;
        const double error = std::hypot(miss.x, miss.y);
        CAPTURE(scene.family);
        CAPTURE(scene.name);
        CHECK(body.position(sample.time, scene.law, scene.space) == state.position);
        outcome.worst = std::max(outcome.worst, error);
        CHECK(error <= bound);
        outcome.wrong_counts += events == sample.events ? 0 : 1;
        outcome.wrong_modes += state.mode == sample.mode ? 0 : 1;
    }
    ++outcome.scenes;
}

// `bounds`: the greatest error of a family [px]; 2e-12 for those that are not named.
std::map<std::string, Outcome> outcomes_of(
    const std::string& file, const std::map<std::string, double>& bounds
) {
    std::map<std::string, Outcome> outcomes;
    for (const ReferenceScene& scene :
         test::read_references(std::string(HYRAX_SOURCE_DIR) + "/tests/golden/" + file)) {
        const auto bound = bounds.find(scene.family);
        compare(scene, bound == bounds.end() ? 2e-12 : bound->second, outcomes[scene.family]);
    }
    for (const auto& [family, outcome] : outcomes) {
        MESSAGE(family, ": ", outcome.scenes, " scenes, worst error ", outcome.worst, " px");
        CAPTURE(family);
        CHECK(outcome.wrong_counts == 0);
        CHECK(outcome.wrong_modes == 0);
    }
    return outcomes;
}

int scenes_in(const std::map<std::string, Outcome>& outcomes) {
    int scenes = 0;
    for (const auto& [family, outcome] : outcomes) {
        scenes += outcome.scenes;
    }
    return scenes;
}

}  // namespace

TEST_CASE("golden: one box, eleven families of scenes") {
    const auto outcomes = outcomes_of(
        "box.csv",
        {{"fling", 5e-12}, {"elastic", 3e-10}, {"elastic_drag", 3e-10}, {"grazing", 1e-5}}
    );
    CHECK(outcomes.size() == 11);
    CHECK(scenes_in(outcomes) >= 300);
}

TEST_CASE("golden: several monitors") {
    const auto outcomes = outcomes_of("arena.csv", {});
    CHECK(outcomes.size() >= 8);
    CHECK(scenes_in(outcomes) >= 100);
}

TEST_CASE("golden: ledges") {
    // One body slides under a strong friction and then falls for two seconds: half a rounding of
    // its place becomes ten roundings.
    CHECK(scenes_in(outcomes_of("ledges.csv", {{"one", 1e-11}})) >= 40);
}
