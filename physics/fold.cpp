// SPDX-License-Identifier: MIT
#include "physics/fold.h"

#include "physics/phi.h"

#include <algorithm>
#include <cmath>

namespace hyrax {
namespace {

// The flights after the first wall: the n-th crosses `width` at speed * restitution^n.
struct Crossings {
    double width;
    double speed;  // Of the flight that leaves the first wall.
    double restitution;

    // The moment at which n crossings are complete.
    double end(double n) const {
        if (restitution == 1.0) {
            return n * width / speed;
        }
        const double growth = -std::log(restitution);
        return width / speed * std::expm1(n * growth) * restitution / (1.0 - restitution);
    }

    double complete_at(double time) const {
        if (restitution == 1.0) {
            return std::floor(time * speed / width);
        }
        const double estimate = std::floor(
            std::log1p(time * speed * (1.0 - restitution) / restitution / width) /
            -std::log(restitution)
        );
        // The logarithm may be off by a rounding, and so by a whole crossing.
        if (estimate > 0.0 && end(estimate) > time) {
            return estimate - 1.0;
        }
        return end(estimate + 1.0) <= time ? estimate + 1.0 : estimate;
    }
};

}  // namespace

FoldedMotion fold(
    double position, double velocity, Support walls, double restitution, double drag, double t
) {
    const double width = walls.right - walls.left;
    if (width <= 0.0 || velocity == 0.0) {
        return {position, 0.0, 0.0};
    }
    const PhiFunctions phi = phi_functions(-drag * t);
    const double time = t * phi.phi1;
    const bool to_the_right = velocity > 0.0;
    const double first_wall = to_the_right ? walls.right : walls.left;
    const double speed = std::fabs(velocity);
    const double until_first = std::fabs(first_wall - position) / speed;
    if (time < until_first) {
        return {position + velocity * time, velocity * phi.exp, 0.0};
    }
    const Crossings crossings{width, restitution * speed, restitution};
    if (crossings.speed == 0.0) {
        return {first_wall, 0.0, 1.0};
    }
    const double after_first = time - until_first;
    const double complete = crossings.complete_at(after_first);
    const double speed_now = crossings.speed * std::pow(restitution, complete);
    const double way = std::clamp((after_first - crossings.end(complete)) * speed_now, 0.0, width);
    const bool from_the_right = to_the_right == (std::fmod(complete, 2.0) == 0.0);
    return {
        from_the_right ? walls.right - way : walls.left + way,
        (from_the_right ? -speed_now : speed_now) * phi.exp,
        complete + 1.0,
    };
}

}  // namespace hyrax
