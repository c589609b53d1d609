// SPDX-License-Identifier: MIT
// When a body in flight meets a vertical or horizontal line. Times in [s], infinity for never;
// lengths in [px], speeds in [px/s], gravity in [px/s^2], drag in [1/s].
#pragma once

namespace hyrax {

/// Motion along an axis without a force: the time to go `distance` >= 0 at `speed` > 0. In the
/// stopping-distance variable s = (1 - e^(-drag t)) / drag the motion is uniform.
double glide_time(double distance, double speed, double drag);

/// The time until `speed` has decayed to `slower`, zero if it is not quicker.
double decay_time(double speed, double slower, double drag);

/// The time after which a body that starts at height 0 with `velocity` (down is positive) moves
/// downwards through the line `depth` below it. A negative depth is a line above: the body must
/// rise past it first. Zero at once if the body lies on the line and does not rise.
double fall_time(double depth, double velocity, double gravity, double drag);

/// The time after which a body that rises at `speed` > 0 reaches a line `height` >= 0 above it
/// while still rising.
double rise_time(double height, double speed, double gravity, double drag);

}  // namespace hyrax
