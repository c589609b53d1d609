// SPDX-License-Identifier: MIT
#include "physics/physics.h"

#include <cmath>

namespace hyrax {

physics::physics() : physics(0.0, 0.0) {}

physics::physics(double x, double y, double vx, double vy) : x_(x), y_(y), vx_(vx), vy_(vy) {}

// Each statement rounds exactly where the document's does: kernels and golden hashes rely on it.
void physics::update(
    double dt, int screen_width, int screen_height, int object_width, int object_height
) {
    vy_ += constants_.gravity * dt;
    vx_ *= constants_.air_drag;
    vy_ *= constants_.air_drag;

    x_ += vx_ * dt;
    y_ += vy_ * dt;

    const double right = static_cast<double>(screen_width - object_width);
    const double bottom = static_cast<double>(screen_height - object_height);

    if (x_ < 0.0) {
        x_ = 0.0;
        vx_ = -vx_ * constants_.restitution;
    } else if (x_ > right) {
        x_ = right;
        vx_ = -vx_ * constants_.restitution;
    }

    if (y_ < 0.0) {
        y_ = 0.0;
        vy_ = -vy_ * constants_.restitution;
    } else if (y_ > bottom) {
        y_ = bottom;
        vy_ = -vy_ * constants_.restitution;
        vx_ *= constants_.ground_friction;
        if (std::fabs(vy_) < constants_.rest_threshold) {
            vy_ = 0.0;
        }
    }
}

void physics::setPos(double x, double y) {
    x_ = x;
    y_ = y;
}

void physics::setVelocity(double vx, double vy) {
    vx_ = vx;
    vy_ = vy;
}

void physics::resetVelocity() {
    setVelocity(0.0, 0.0);
}

}  // namespace hyrax
