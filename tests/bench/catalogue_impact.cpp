// SPDX-License-Identifier: MIT
// Single impacts and many of them.
#include "tests/bench/catalogue_parts.h"
#include "tests/bench/catalogue_reference.h"
#include "tests/bench/catalogue_runner.h"

#include <algorithm>

namespace hyrax::bench {
namespace {

constexpr double frame_60_hz = 1.0 / 60.0;
constexpr PhysicsConstants elastic{
    .restitution = 1.0, .air_drag = 1.0, .ground_friction = 1.0, .rest_threshold = 5.0
};

double first_rebound(Column column) {
    constexpr double peak = 316.470;  // From 952 px.
    Scene scene;
    scene.bounds = open_floor;
    bool has_bounced = false;
    double height = 0.0;
    run(*launch(column, scene), 3.0, 60.0, [&](const BodyState& state) {
        has_bounced = has_bounced || state.velocity.y < 0.0;
        if (has_bounced) {
            height = worse(height, scene.bounds.bottom - state.position.y);
        }
    });
    return std::fabs(height - peak);
}

double grazed_ceiling(Column column) {
    constexpr double gap = 1e-9;
    Scene scene = Scene::of({.air_drag = 1.0});
    scene.position = {100.0, 500.0};
    const double speed = std::sqrt(2.0 * scene.law.gravity * (scene.position.y - gap));
    scene.velocity = {0.0, -speed};
    const std::unique_ptr<Runner> runner = launch(column, scene);
    const double back = 2.0 * speed / scene.law.gravity;
    return std::fabs(run(*runner, back, 60.0 / back).velocity.y / speed - 1.0);
}

// The corner is reached a fifth of a frame before the end of a frame.
double corner(Column column) {
    constexpr double impact = 19.8 * frame_60_hz;
    Scene scene = Scene::of({.air_drag = 1.0});
    const Law& law = scene.law;
    scene.position.x = scene.bounds.right - scene.velocity.x * impact;
    scene.position.y = scene.bounds.bottom - 0.5 * law.gravity * impact * impact;
    const Vec2 after{
        -law.restitution * law.impact_friction * scene.velocity.x,
        -law.restitution * law.gravity * impact + law.gravity * 0.2 * frame_60_hz
    };
    const BodyState state = state_after(column, scene, 20.0 * frame_60_hz);
    return distance(state.velocity, after);
}

double no_restitution(Column column) {
    const Scene scene = Scene::of({.restitution = 0.0});
    return std::fabs(rest_x(column, scene) - reference_rest_x(scene));
}

double energy(const Scene& scene, const BodyState& state) {
    const Vec2 v = state.velocity;
    return 0.5 * (v.x * v.x + v.y * v.y) +
           scene.law.gravity * (scene.bounds.bottom - state.position.y);
}

double elastic_energy(Column column) {
    const Scene scene = Scene::of(elastic);
    const double before = energy(scene, {scene.position, scene.velocity, Mode::air});
    const BodyState after = state_after(column, scene, 1e6 * frame_60_hz);
    return std::fabs(energy(scene, after) / before - 1.0);
}

double many_small_hops(Column column) {
    const Scene scene = Scene::of({.rest_threshold = 0.0});
    return std::fabs(rest_x(column, scene) - reference_rest_x(scene));
}

double a_minute_between_walls(Column column) {
    PhysicsConstants weightless = elastic;
    weightless.gravity = 0.0;
    Scene scene = Scene::of(weightless);
    scene.bounds.right = 952.0;
    scene.position.y = 500.0;
    scene.velocity = {333.0, 0.0};
    const double x = state_after(column, scene, 60.0).position.x;
    return std::fabs(x - reference(scene, 60.0).position.x);
}

double fling_in_a_small_box(Column column) {
    Scene scene;
    scene.bounds = {0.0, 0.0, 672.0, 472.0};
    scene.position = {100.0, 100.0};
    scene.velocity = {6000.0, -8000.0};
    return distance(state_after(column, scene, 1.0).position, reference(scene, 1.0).position);
}

Scene huge_fling(double upwards) {
    Scene scene;
    scene.velocity = {1e7, -upwards};
    return scene;
}

double speed_after_huge_fling(Column column) {
    const Scene scene = huge_fling(0.0);
    const double exact = reference(scene, 0.1).velocity.x;
    return std::fabs(std::fabs(state_after(column, scene, 0.1).velocity.x / exact) - 1.0);
}

double rest_after_huge_fling(Column column) {
    const Scene scene = huge_fling(1e7);
    return std::fabs(rest_x(column, scene) - reference_rest_x(scene));
}

constexpr std::array cases{
    CatalogueCase{9, "first rebound's peak at 60 Hz, as frames see it", 2e-1, first_rebound},
    CatalogueCase{16, "apex 1e-9 px below the ceiling: speed lost, relative", 1e-3, grazed_ceiling},
    CatalogueCase{17, "floor and wall at one instant: velocity after [px/s]", 1e-6, corner},
    CatalogueCase{18, "restitution 0: sticks, slides, rest position", 5e-1, no_restitution},
    CatalogueCase{19, "elastic: drift of energy in 1e6 frames, relative", 1e-9, elastic_energy},
    CatalogueCase{21, "rest threshold 0: rest position", 1e-2, many_small_hops},
    CatalogueCase{25, "no gravity, elastic: 60 s at 333 px/s", 1e-6, a_minute_between_walls},
    CatalogueCase{26, "fling of 1e4 px/s in 672 x 472: at 1 s", 1e-3, fling_in_a_small_box},
    CatalogueCase{27, "fling of 1e7 px/s: vx after 0.1 s, relative", 1e-6, speed_after_huge_fling},
    CatalogueCase{28, "fling of 1e7 px/s: rest position", 1e-2, rest_after_huge_fling},
};

}  // namespace

std::span<const CatalogueCase> impact_cases() {
    return cases;
}

}  // namespace hyrax::bench
