// SPDX-License-Identifier: MIT
// The statements of physics::update, one body after the other.
#include "physics/batch.h"

#include <cmath>

namespace hyrax {

void step_scalar(const BatchStep& step) {
    const BatchArrays arrays = step.arrays;
    for (std::size_t i = 0; i < arrays.bodies; ++i) {
        double vx = arrays.vx[i] * step.air_drag;
        double vy = (arrays.vy[i] + step.fall) * step.air_drag;
        double x = arrays.x[i] + vx * step.dt;
        double y = arrays.y[i] + vy * step.dt;

        if (x < 0.0) {
            x = 0.0;
            vx *= step.reflection;
        } else if (x > step.right) {
            x = step.right;
            vx *= step.reflection;
        }

        if (y < 0.0) {
            y = 0.0;
            vy *= step.reflection;
        } else if (y > step.bottom) {
            y = step.bottom;
            vy *= step.reflection;
            vx *= step.ground_friction;
            if (std::fabs(vy) < step.rest_threshold) {
                vy = 0.0;
            }
        }

        arrays.x[i] = x;
        arrays.y[i] = y;
        arrays.vx[i] = vx;
        arrays.vy[i] = vy;
    }
}

}  // namespace hyrax
