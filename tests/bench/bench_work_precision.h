// SPDX-License-Identifier: MIT
// Error against cost, as the work-precision diagrams of the ODE literature have it.
#pragma once

#include "tests/bench/meter.h"

#include <filesystem>
#include <iosfwd>
#include <string>

namespace hyrax::bench {

/// Which cells to run; empty and negative ones stand for all.
struct CellFilter {
    std::string scene;
    std::string method;
    double setting = -1.0;  ///< Frames a second, or rk45's tolerance; 0: events only.
};

/// Errors of position after 1, 2 and 5 s and at rest [px] and the cost of a simulated second, over
/// frame rates and tolerances. `references` is tests/golden/work_precision.csv. False, with a
/// message on stderr, if it cannot be read.
bool work_precision(
    std::ostream& table,
    std::ostream& csv,
    Meter& meter,
    const std::filesystem::path& references,
    const CellFilter& filter
);

}  // namespace hyrax::bench
