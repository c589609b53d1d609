// SPDX-License-Identifier: MIT
// The integrator for forces that have no closed form: Dormand and Prince's 5(4) pair with dense
// output (Hairer, Norsett, Wanner, Solving ODEs I, II.4-6) and impacts located on the dense output.
#pragma once

#include "physics/steppers.h"

#include <vector>

namespace hyrax {

/// Forces besides gravity; both default to none.
struct ForceField {
    Vec2 wind;                    ///< Drag acts on the velocity relative to it [px/s].
    double quadratic_drag = 0.0;  ///< Deceleration = this * speed^2 [1/px], in air only.
    bool operator==(const ForceField&) const = default;
};

struct RungeKuttaSettings {
    double relative_tolerance = 1e-6;
    double absolute_tolerance = 1e-6;  ///< [px] and [px/s]
    /// Trial steps in one call after which the scene counts as too stiff, and the body is put at
    /// rest: an explicit method needs drag / 3.3 steps a second.
    int most_trials = 20'000;
};

/// Motion over `dt` [s] by steps of its own length. `step` is the length to try first [s], and then
/// the one for the next call; start with `dt`.
BodyState step_runge_kutta(
    BodyState state,
    const Law& law,
    const ForceField& forces,
    const FreeSpace& space,
    const RungeKuttaSettings& settings,
    double dt,
    double& step,
    std::vector<Impact>& impacts
);

}  // namespace hyrax
