// SPDX-License-Identifier: MIT
// Frames that are long, uneven, many or none.
#include "tests/bench/catalogue_parts.h"
#include "tests/bench/catalogue_reference.h"
#include "tests/bench/catalogue_runner.h"

namespace hyrax::bench {
namespace {

double sleep_in_flight(Column column) {
    const std::unique_ptr<Runner> runner = launch(column, {});
    run(*runner, 0.5);
    runner->advance(from_seconds(3600.0));
    const BodyState state = runner->state();
    const BodyState rest = reference({}, 3600.5);
    return worse(
        distance(state.position, rest.position), std::hypot(state.velocity.x, state.velocity.y)
    );
}

double ten_frames_a_second(Column column) {
    return distance(state_after(column, {}, 2.0, 10.0).position, reference({}, 2.0).position);
}

double no_time(Column column) {
    Scene scene;
    scene.position.y = 500.0;
    const std::unique_ptr<Runner> runner = launch(column, scene);
    for (int i = 0; i < 1000; ++i) {
        runner->advance(0);
    }
    const Vec2 v = runner->state().velocity;
    return std::fabs(std::hypot(v.x, v.y) / scene.velocity.x - 1.0);
}

double long_uptime(Column column) {
    const Scene scene{.start = from_seconds(1e7)};
    return distance(state_after(column, scene, 2.0).position, reference(scene, 2.0).position);
}

double uneven_frames(Column column) {
    const std::unique_ptr<Runner> runner = launch(column, {});
    for (double t = 0.0; t < until_rest; t += 1.0 / 48.0 + 1.0 / 144.0) {
        runner->advance(from_seconds(1.0 / 144.0));
        runner->advance(from_seconds(1.0 / 48.0));
    }
    return std::fabs(runner->state().position.x - reference_rest_x({}));
}

// One unit for each of its million bounces is what a scheme may take that follows them all. Those
// that give up after some thousands in a frame pass as well: the case is about cost.
double quick_in_a_tiny_box(Column column) {
    Scene scene = Scene::of({.restitution = 1.0, .air_drag = 1.0, .ground_friction = 1.0});
    scene.bounds.right = 10.0;
    scene.position.x = 5.0;
    scene.velocity = {1e7, 0.0};
    const std::unique_ptr<Runner> runner = launch(column, scene);
    run(*runner, 1.0);
    return static_cast<double>(runner->work());
}

constexpr std::array cases{
    CatalogueCase{13, "one frame of 3600 s in flight: at rest after it", 1e-3, sleep_in_flight},
    CatalogueCase{14, "10 frames a second: at 2 s", 1e-3, ten_frames_a_second},
    CatalogueCase{40, "1000 frames of 0 s: speed lost, relative", 0.0, no_time},
    CatalogueCase{51, "uptime of 1e7 s: 2 s after a launch", 1e-4, long_uptime},
    CatalogueCase{55, "frames of 1/48 s and 1/144 s: rest position", 1e-3, uneven_frames},
    CatalogueCase{57, "elastic, 1e7 px/s in 10 px, 1 s: work", 1.05e6, quick_in_a_tiny_box},
};

}  // namespace

std::span<const CatalogueCase> time_cases() {
    return cases;
}

}  // namespace hyrax::bench
