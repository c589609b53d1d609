// SPDX-License-Identifier: MIT
// Containment, walls that move, energy, and symmetries.
#include "tests/bench/catalogue_parts.h"
#include "tests/bench/catalogue_reference.h"
#include "tests/bench/catalogue_runner.h"

#include <algorithm>
#include <random>
#include <vector>

namespace hyrax::bench {
namespace {

// The same numbers on every machine, which the library's distributions do not promise.
class Dice {
public:
    double between(double low, double high) {
        const double share = static_cast<double>(random_()) / 2147483647.0;
        return low + (high - low) * share;
    }

private:
    std::minstd_rand random_{1};
};

// Infinite for a state that is not finite.
double outside(const Bounds& bounds, Vec2 p) {
    const double x = std::max(bounds.left - p.x, p.x - bounds.right);
    const double y = std::max(bounds.top - p.y, p.y - bounds.bottom);
    return std::isfinite(p.x) && std::isfinite(p.y) ? std::max({x, y, 0.0}) : infinity;
}

double impossible_speed(Column column) {
    Scene scene;
    scene.velocity = {1e200, 0.0};
    double worst = 0.0;
    run(*launch(column, scene), 1.0, 60.0, [&](const BodyState& state) {
        worst = worse(worst, outside(scene.bounds, state.position));
        const bool is_finite = std::isfinite(state.velocity.x) && std::isfinite(state.velocity.y);
        worst = is_finite ? worst : infinity;
    });
    return worst;
}

double containment(Column column) {
    Dice dice;
    double worst = 0.0;
    for (int i = 0; i < 2000; ++i) {
        Scene scene;
        scene.position = {dice.between(0.0, 1792.0), dice.between(0.0, 952.0)};
        scene.velocity = {dice.between(-1e6, 1e6), dice.between(-1e6, 1e6)};
        const std::unique_ptr<Runner> runner = launch(column, scene);
        for (int frame = 0; frame < 10; ++frame) {
            runner->advance(from_seconds(dice.between(0.0, 1.0)));
            worst = worse(worst, outside(scene.bounds, runner->state().position));
        }
    }
    return worst;
}

double gained_height(Column column) {
    Dice dice;
    double worst = 0.0;
    for (int i = 0; i < 1000; ++i) {
        Scene scene;
        scene.position = {dice.between(0.0, 1792.0), dice.between(0.0, 952.0)};
        scene.velocity = {dice.between(-1500.0, 1500.0), dice.between(-1500.0, 1500.0)};
        const auto height = [&scene](Vec2 p, Vec2 v) {
            return (v.x * v.x + v.y * v.y) / (2.0 * scene.law.gravity) - p.y;
        };
        double before = height(scene.position, scene.velocity);
        run(*launch(column, scene), 6.0, 60.0, [&](const BodyState& state) {
            const double now = height(state.position, state.velocity);
            worst = worse(worst, now - before);
            before = now;
        });
    }
    return worst;
}

double no_room(Column column) {
    Scene scene;
    scene.bounds.right = 0.0;
    scene.position.x = 0.0;
    scene.velocity.x = 500.0;
    double worst = 0.0;
    const std::unique_ptr<Runner> runner = launch(column, scene);
    run(*runner, 1.0, 60.0, [&](const BodyState& state) {
        worst = worse(worst, std::fabs(state.position.x));
    });
    return worse(worst, std::fabs(runner->state().velocity.x));
}

double put_outside(Column column) {
    Scene scene;
    scene.position = {-40.0, 500.0};
    scene.velocity = {500.0, 0.0};
    const double vx = state_after(column, scene, 2.0 / 60.0).velocity.x;
    return std::fabs(1.0 - std::fabs(vx) / scene.velocity.x);
}

double floor_rises(Column column) {
    Scene scene;
    scene.position.y = scene.bounds.bottom;
    scene.velocity = {0.0, -900.0};
    const std::unique_ptr<Runner> runner = launch(column, scene);
    run(*runner, 1.0 / 60.0);
    Bounds raised = scene.bounds;
    raised.bottom -= 200.0;
    runner->confine(raised);
    return run(*runner, 1.0 / 60.0).velocity.y < 0.0 ? 0.0 : 1.0;
}

double floor_sinks(Column column) {
    Scene scene;
    scene.position.y = scene.bounds.bottom;
    scene.velocity = {};
    const std::unique_ptr<Runner> runner = launch(column, scene);
    run(*runner, 2.0);
    Bounds lowered = scene.bounds;
    lowered.bottom += 100.0;
    runner->confine(lowered);
    double highest = 0.0;
    run(*runner, 0.5, 60.0, [&](const BodyState& state) {
        highest = worse(highest, scene.bounds.bottom - state.position.y);
    });
    return highest;
}

std::vector<Vec2> path(Column column, const Scene& scene) {
    std::vector<Vec2> places;
    run(*launch(column, scene), 5.0, 60.0, [&](const BodyState& state) {
        places.push_back(state.position);
    });
    return places;
}

// The largest distance between two paths, where `image` shows the second one in the first.
template <typename Image>
double difference(Column column, const Scene& scene, const Scene& other, Image image) {
    const std::vector<Vec2> places = path(column, scene);
    const std::vector<Vec2> others = path(column, other);
    double worst = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        worst = worse(worst, distance(places[i], image(others[i])));
    }
    return worst;
}

double translation(Column column) {
    constexpr Vec2 shift{-3840.0, -1080.0};
    const Scene scene;
    Scene shifted = scene;
    shifted.position = scene.position + shift;
    shifted.bounds = {
        shift.x, shift.y, scene.bounds.right + shift.x, scene.bounds.bottom + shift.y
    };
    return difference(column, scene, shifted, [shift](Vec2 p) { return p - shift; });
}

double mirror(Column column) {
    const Scene scene;
    Scene mirrored = scene;
    mirrored.position.x = scene.bounds.right - scene.position.x;
    mirrored.velocity.x = -scene.velocity.x;
    return difference(column, scene, mirrored, [&scene](Vec2 p) {
        return Vec2{scene.bounds.right - p.x, p.y};
    });
}

double scale(Column column) {
    constexpr double factor = 1 << 20;
    Scene scene;
    scene.bounds = {0.0, 0.0, 672.0, 472.0};
    Scene scaled = scene;
    scaled.constants.gravity *= factor;
    scaled.constants.rest_threshold *= factor;
    scaled.law.gravity *= factor;
    scaled.law.rest_speed *= factor;
    scaled.law.stop_speed *= factor;
    scaled.tolerances.absolute_tolerance *= factor;
    scaled.bounds.right *= factor;
    scaled.bounds.bottom *= factor;
    scaled.position = scene.position * factor;
    scaled.velocity = scene.velocity * factor;
    const auto image = [](Vec2 p) { return p * (1.0 / factor); };
    return difference(column, scene, scaled, image) / scene.bounds.right;
}

constexpr std::array cases{
    CatalogueCase{29, "v = 1e200 px/s: inside and finite for 1 s", 0.0, impossible_speed},
    CatalogueCase{30, "2000 flings to 1e6 px/s, frames to 1 s: outside", 1e-9, containment},
    CatalogueCase{31, "1000 flings at 60 Hz: height gained in a frame", 1e-9, gained_height},
    CatalogueCase{43, "no room in x: pinned, vx = 0 after 1 s", 0.0, no_room},
    CatalogueCase{44, "put 40 px outside, moving in: speed lost, relative", 1e-2, put_outside},
    CatalogueCase{45, "floor raised under a rising body: rises (1 if not)", 0.0, floor_rises},
    CatalogueCase{46, "floor lowered under a resting body: hop", 1e-9, floor_sinks},
    CatalogueCase{47, "moved to a monitor at (-3840, -1080): difference", 1e-9, translation},
    CatalogueCase{48, "mirrored left to right: difference", 1e-9, mirror},
    CatalogueCase{49, "scaled by 2^20: difference, relative", 1e-12, scale},
};

}  // namespace

std::span<const CatalogueCase> bounds_cases() {
    return cases;
}

}  // namespace hyrax::bench
