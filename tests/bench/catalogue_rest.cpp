// SPDX-License-Identifier: MIT
// Sliding, coming to rest, and staying there.
#include "tests/bench/catalogue_parts.h"
#include "tests/bench/catalogue_reference.h"
#include "tests/bench/catalogue_runner.h"

namespace hyrax::bench {
namespace {

double speed(const BodyState& state) {
    return std::fabs(state.velocity.x) + std::fabs(state.velocity.y);
}

double at_rest_at(Column column) {
    return std::fabs(rest_x(column, {}) - reference_rest_x({}));
}

double rest_over_rates(Column column) {
    return spread_over_rates([column](double rate) { return rest_x(column, {}, rate); });
}

Scene heavy(double velocity) {
    Scene scene = Scene::of({.gravity = 1e9});
    scene.velocity.x = velocity;
    return scene;
}

double heavy_rest(Column column) {
    const Scene scene = heavy(0.0);
    const BodyState state = state_after(column, scene, 1.0);
    return worse(speed(state), std::fabs(state.position.y - scene.bounds.bottom));
}

double heavy_throw(Column column) {
    const Scene scene = heavy(300.0);
    return std::fabs(rest_x(column, scene) - reference_rest_x(scene));
}

Scene on_floor(double velocity) {
    Scene scene;
    scene.position.y = scene.bounds.bottom;
    scene.velocity = {velocity, 0.0};
    return scene;
}

double placed_on_floor(Column column) {
    const std::unique_ptr<Runner> runner = launch(column, on_floor(0.0));
    run(*runner, 1.0);
    double fastest = 0.0;
    run(*runner, 10.0 / 60.0, 60.0, [&](const BodyState& state) {
        fastest = worse(fastest, std::fabs(state.velocity.y));
    });
    return fastest;
}

double settled(Column column) {
    return speed(state_after(column, {}, 10.0));
}

double hop_after_an_hour(Column column) {
    const Scene scene = on_floor(0.0);
    const std::unique_ptr<Runner> runner = launch(column, scene);
    run(*runner, 1.0);
    runner->advance(from_seconds(3600.0));
    double height = scene.bounds.bottom - runner->state().position.y;
    run(*runner, 1.0, 60.0, [&](const BodyState& state) {
        height = worse(height, scene.bounds.bottom - state.position.y);
    });
    return height;
}

constexpr double sliding = 500.0;  // [px/s]

double slide(Column column, double rate) {
    const Scene scene = on_floor(sliding);
    return rest_x(column, scene, rate) - scene.position.x;
}

double slide_length(Column column) {
    const Law law = law_from({});
    return std::fabs(slide(column, 60.0) - (sliding - law.stop_speed) / law.ground_drag);
}

double slide_over_rates(Column column) {
    return spread_over_rates([column](double rate) { return slide(column, rate); });
}

double without_friction(Column column) {
    Scene scene = on_floor(sliding);
    scene.constants.ground_friction = 1.0;
    scene.law = law_from(scene.constants);
    return std::fabs(state_after(column, scene, 2.0).position.x - reference(scene, 2.0).position.x);
}

double crawl(Column column) {
    const BodyState state = state_after(column, on_floor(sliding), 120.0);
    return state.velocity.x == 0.0 ? 0.0 : 1.0;
}

double drift_asleep(Column column) {
    const std::unique_ptr<Runner> runner = launch(column, {});
    const Vec2 before = run(*runner, until_rest).position;
    double drift = 0.0;
    run(*runner, 1e5 / 60.0, 60.0, [&](const BodyState& state) {
        const Vec2 moved = state.position - before;
        drift = worse(drift, std::fabs(moved.x) + std::fabs(moved.y));
    });
    return drift;
}

// A cycle of two frames passes through 0 as well: the last two frames count.
double rebound_at_threshold(Column column) {
    Scene scene = on_floor(0.0);
    scene.velocity.y = scene.law.rest_speed / scene.law.restitution;
    const std::unique_ptr<Runner> runner = launch(column, scene);
    const double last_but_one = std::fabs(run(*runner, 59.0 / 60.0).velocity.y);
    return worse(last_but_one, std::fabs(run(*runner, 1.0 / 60.0).velocity.y));
}

constexpr std::array cases{
    CatalogueCase{10, "the document's throw at 60 Hz: rest position", 1e-3, at_rest_at},
    CatalogueCase{11, "the same: spread over 24 to 240 Hz", 1e-3, rest_over_rates},
    CatalogueCase{23, "gravity 1e9 px/s^2: at rest on the floor after 1 s", 1e-6, heavy_rest},
    CatalogueCase{24, "gravity 1e9 px/s^2: rest position of 300 px/s", 1e-2, heavy_throw},
    CatalogueCase{32, "put on the floor: vy after 1 s [px/s]", 0.0, placed_on_floor},
    CatalogueCase{33, "dropped, 10 s later: speed [px/s]", 0.0, settled},
    CatalogueCase{34, "at rest, one frame of 3600 s: hop after it", 1e-9, hop_after_an_hour},
    CatalogueCase{35, "slide from 500 px/s at 60 Hz: length", 1e-6, slide_length},
    CatalogueCase{36, "slide from 500 px/s: spread over 24 to 240 Hz", 1e-3, slide_over_rates},
    CatalogueCase{38, "no friction: 500 px/s on the floor for 2 s", 1e-3, without_friction},
    CatalogueCase{39, "120 s on the floor: vx is 0 (1 if not)", 0.0, crawl},
    CatalogueCase{52, "asleep for 1e5 frames: drift", 0.0, drift_asleep},
    CatalogueCase{53, "rebound at the threshold: vy at 1 s [px/s]", 0.0, rebound_at_threshold},
};

}  // namespace

std::span<const CatalogueCase> rest_cases() {
    return cases;
}

}  // namespace hyrax::bench
