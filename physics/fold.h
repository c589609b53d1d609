// SPDX-License-Identifier: MIT
// Any number of bounces between two walls at once.
#pragma once

#include "physics/free_space.h"

namespace hyrax {

struct FoldedMotion {
    double position = 0.0;  ///< [px]
    double velocity = 0.0;  ///< [px/s]
    double bounces = 0.0;   ///< A whole number, as large as it may be.
};

/// Where a body between walls that starts with this position and velocity is after `t` [s], under
/// linear drag [1/s]. In the stopping-distance variable speed is constant between bounces, so that
/// the times of bounces are a geometric series. Relative error below 1e-9.
FoldedMotion fold(
    double position, double velocity, Support walls, double restitution, double drag, double t
);

}  // namespace hyrax
