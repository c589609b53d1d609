// SPDX-License-Identifier: MIT
#include "physics/law.h"

#include <algorithm>
#include <cmath>

namespace hyrax {
namespace {

constexpr double greatest_rate = 1e300;
constexpr double slowest_slide = 5.0;

double rate_of(double multiplier, double frames_per_second) {
    // Adding zero turns the -0 of a multiplier of 1 into 0.
    return std::min(-frames_per_second * std::log(multiplier) + 0.0, greatest_rate);
}

}  // namespace

Law law_from(const PhysicsConstants& constants, double reference_rate) {
    const double drag = rate_of(constants.air_drag, reference_rate);
    const double friction = rate_of(constants.ground_friction, reference_rate);
    return {
        .gravity = constants.gravity,
        .drag = drag,
        .ground_drag = drag + friction,
        .restitution = constants.restitution,
        .impact_friction = constants.ground_friction,
        .rest_speed =
            std::max(constants.rest_threshold, std::sqrt(2.0 * constants.gravity * visible_hop)),
        .stop_speed = slowest_slide,
    };
}

}  // namespace hyrax
