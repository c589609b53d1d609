// SPDX-License-Identifier: MIT
// What is seen of an engine from outside, for tests of what a caller may get wrong.
#pragma once

#include "tests/core/engine_world.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hyrax {

inline constexpr Integrator integrators[] = {
    Integrator::event_driven,
    Integrator::semi_implicit_euler,
    Integrator::semi_implicit_euler_fixed,
    Integrator::exponential_swept,
    Integrator::stormer_verlet,
    Integrator::rk45,
};

inline Arena one_monitor(Rect bounds) {
    return Arena({monitor(bounds)}, FloorEdge::work_area);
}

inline bool is_finite(Vec2 v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

/// All that a caller can see of an engine.
struct Seen {
    std::vector<Pet> pets;
    std::vector<PetId> ids;
    std::size_t awake = 0;
    EngineSettings settings;

    explicit Seen(const Engine& engine) : awake(engine.awake_count()), settings(engine.settings()) {
        engine.for_each([this](PetId id, const Pet& pet) {
            ids.push_back(id);
            pets.push_back(pet);
        });
    }
};

/// Pets compare by what is seen of them; that their motion is the same shows in what follows.
inline bool same(const Seen& a, const Seen& b) {
    return a.ids == b.ids && a.awake == b.awake && a.settings == b.settings &&
           std::ranges::equal(a.pets, b.pets, [](const Pet& one, const Pet& other) {
               return same(one, other) && one.since == other.since &&
                      one.spawn_position == other.spawn_position && one.tag == other.tag;
           });
}

}  // namespace hyrax
