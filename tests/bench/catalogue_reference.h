// SPDX-License-Identifier: MIT
// The law in extended precision, by the textbook's formulas and bisection: what the cases compare
// with. It shares no code with physics/.
#pragma once

#include "tests/bench/catalogue_runner.h"

namespace hyrax::bench {

/// The state `seconds` after the launch. The scene's bounds are finite or open, and it is launched
/// inside them and with gravity or without drag.
BodyState reference(const Scene& scene, double seconds);

inline double reference_rest_x(const Scene& scene) {
    return reference(scene, until_rest).position.x;
}

}  // namespace hyrax::bench
