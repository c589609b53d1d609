// SPDX-License-Identifier: MIT
// One axis of a motion with linear drag and a constant force, in closed form.
#pragma once

#include "physics/phi.h"

namespace hyrax {

struct AxisState {
    double offset = 0.0;    ///< Way made since the start [px].
    double velocity = 0.0;  ///< [px/s]
};

/// After `t` >= 0 [s] of v' = force - drag v from `velocity`; drag [1/s], force [px/s^2].
inline AxisState fly(double velocity, double force, double drag, double t) {
    if (drag == 0.0) {
        return {t * (velocity + 0.5 * force * t), velocity + force * t};
    }
    const PhiFunctions phi = phi_functions(-drag * t);
    return {
        t * (velocity * phi.phi1 + force * t * phi.phi2), velocity * phi.exp + force * t * phi.phi1
    };
}

/// The same without a force.
inline AxisState glide(double velocity, double drag, double t) {
    if (drag == 0.0) {
        return {velocity * t, velocity};
    }
    const PhiFunctions phi = phi_functions(-drag * t);
    return {velocity * t * phi.phi1, velocity * phi.exp};
}

}  // namespace hyrax
