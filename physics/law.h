// SPDX-License-Identifier: MIT
// The continuous model that the document's frame-by-frame law samples: rates instead of
// multipliers.
#pragma once

#include "physics/physics.h"

namespace hyrax {

/// Flight: x'' = -drag x', y'' = gravity - drag y'. On the ground: x'' = -(drag + friction) x'.
/// docs/physics.md derives it. Every field is finite and not negative.
struct Law {
    double gravity = 0.0;          ///< Downward acceleration [px/s^2].
    double drag = 0.0;             ///< Decay of velocity in air [1/s].
    double ground_drag = 0.0;      ///< Decay of velocity on the ground, air included [1/s].
    double restitution = 0.0;      ///< Speed kept by an impact, 0 to 1.
    double impact_friction = 0.0;  ///< Horizontal velocity kept by an impact on a floor, 0 to 1.
    double rest_speed = 0.0;       ///< Rebounds slower than this do not leave the floor [px/s].
    double stop_speed = 0.0;       ///< Slower than this a body on the ground stops [px/s].

    bool operator==(const Law&) const = default;
};

/// The frame rate at which the document's multipliers mean what they say [1/s].
inline constexpr double default_reference_rate = 60.0;

/// A hop lower than this cannot be seen [px]. It bounds rest_speed from below, so that strong
/// gravity with little damping ends in rest instead of in ever quicker hops.
inline constexpr double visible_hop = 0.01;

/// The law that agrees with the document's multipliers at `reference_rate` frames a second:
/// drag = -rate ln(air_drag), and likewise for friction. A multiplier of 0 becomes a rate of 1e300.
Law law_from(const PhysicsConstants& constants, double reference_rate = default_reference_rate);

}  // namespace hyrax
