// SPDX-License-Identifier: MIT
// Flight without walls.
#include "tests/bench/catalogue_parts.h"
#include "tests/bench/catalogue_reference.h"
#include "tests/bench/catalogue_runner.h"

namespace hyrax::bench {
namespace {

Scene flight(const PhysicsConstants& constants = {}) {
    Scene scene = Scene::of(constants);
    scene.bounds = open;
    scene.position = {};
    scene.velocity = {600.0, -1500.0};
    return scene;
}

// For rates that no multiplier can express.
Scene flight_with_drag(double drag) {
    Scene scene = flight({.air_drag = std::exp(-drag / default_reference_rate)});
    scene.law.drag = drag;
    return scene;
}

double one_second(Column column) {
    const Scene scene = flight();
    return distance(state_after(column, scene, 1.0).position, reference(scene, 1.0).position);
}

double height_over_rates(Column column) {
    return spread_over_rates([column](double rate) {
        return state_after(column, flight(), 1.0, rate).position.y;
    });
}

double an_hour_of_fall(Column column) {
    constexpr double t = 3600.0;
    Scene scene = flight({.air_drag = 1.0});
    scene.velocity = {};
    const double exact = 0.5 * scene.law.gravity * t * t;
    return std::fabs(state_after(column, scene, t).position.y / exact - 1.0);
}

double hardly_any_drag(Column column) {
    Scene scene = flight_with_drag(1e-14);
    scene.velocity = {};
    const double parabola = 0.5 * scene.law.gravity;
    return std::fabs(state_after(column, scene, 1.0).position.y - parabola);
}

constexpr double stiff = 1e4;  // [1/s]

double terminal_speed(Column column) {
    Scene scene = flight_with_drag(stiff);
    scene.velocity = {};
    const double exact = scene.law.gravity / stiff;
    return std::fabs(state_after(column, scene, 1.0).velocity.y / exact - 1.0);
}

double stopping_distance(Column column) {
    Scene scene = flight_with_drag(stiff);
    scene.velocity.x = 1e4;
    return std::fabs(state_after(column, scene, 1.0).position.x - scene.velocity.x / stiff);
}

double nothing_moves(Column column) {
    const Scene scene = flight({.air_drag = 0.0});
    return distance(state_after(column, scene, 1.0).position, scene.position);
}

double partitions(Column column) {
    const Scene scene = flight();
    const Vec2 sixty = state_after(column, scene, 1.0).position;
    double spread = 0.0;
    for (const double frames : {61.0, 1000.0, 7.0}) {
        spread = worse(spread, distance(sixty, state_after(column, scene, 1.0, frames).position));
    }
    return spread;
}

constexpr std::array cases{
    CatalogueCase{1, "free flight for 1 s at 60 Hz", 1e-6, one_second},
    CatalogueCase{2, "free flight: spread of y(1 s) over 24 to 240 Hz", 1e-6, height_over_rates},
    CatalogueCase{3, "free fall for 3600 s without drag: y, relative", 1e-11, an_hour_of_fall},
    CatalogueCase{4, "drag 1e-14 /s: y(1 s) against the parabola", 1e-6, hardly_any_drag},
    CatalogueCase{5, "drag 1e4 /s: terminal speed, relative", 1e-9, terminal_speed},
    CatalogueCase{6, "drag 1e4 /s: stopping distance from 1e4 px/s", 1e-6, stopping_distance},
    CatalogueCase{7, "drag 1e300 /s: stays where it is", 1e-6, nothing_moves},
    CatalogueCase{42, "1 s as 60, 61, 1000 and 7 frames: spread", 1e-9, partitions},
};

}  // namespace

std::span<const CatalogueCase> flight_cases() {
    return cases;
}

}  // namespace hyrax::bench
