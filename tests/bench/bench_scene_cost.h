// SPDX-License-Identifier: MIT
// A scene pays for what it has: what each feature costs the default integrator.
#pragma once

#include "tests/bench/meter.h"

#include <iosfwd>

namespace hyrax::bench {

/// Nanoseconds and instructions of a pet and frame at 60 Hz, or of one event, for scenes that have
/// one feature more or less than the one before.
void scene_cost(std::ostream& table, std::ostream& csv, Meter& meter);

}  // namespace hyrax::bench
