// SPDX-License-Identifier: MIT
// A motion with linear drag and a constant force, in closed form, axis by axis.
#pragma once

#include "physics/phi.h"

namespace hyrax {

struct AxisState {
    double offset = 0.0;    ///< Way made since the start [px].
    double velocity = 0.0;  ///< [px/s]
};

/// v' = force - drag v over a span of time, for as many axes as there are.
class Flight {
public:
    /// `drag` >= 0 [1/s]; `t` >= 0 [s].
    Flight(double drag, double t) : t_(t), decay_(drag * t) {
        if (decay_ > 0.0) {
            phi_ = phi_functions(-decay_);
        }
    }

    /// The end of the span from `velocity`; force [px/s^2].
    AxisState from(double velocity, double force) const {
        if (decay_ < slight_decay) {
            // As a change to what was there before: a small one is rounded less than a product.
            const double change = t_ * force - decay_ * velocity;
            return {t_ * (velocity + change * phi_.phi2), velocity + change * phi_.phi1};
        }
        return {
            t_ * (velocity * phi_.phi1 + force * t_ * phi_.phi2),
            velocity * phi_.exp + force * t_ * phi_.phi1
        };
    }

private:
    // What is left of a strong decay would be a small difference of large terms.
    static constexpr double slight_decay = 0.25;

    double t_;
    double decay_;
    PhiFunctions phi_;
};

/// Flight for a single axis.
inline AxisState fly(double velocity, double force, double drag, double t) {
    return Flight(drag, t).from(velocity, force);
}

/// The same without a force.
inline AxisState glide(double velocity, double drag, double t) {
    return Flight(drag, t).from(velocity, 0.0);
}

}  // namespace hyrax
