// SPDX-License-Identifier: MIT
// What a piece of work costs: nanoseconds, and instructions where they can be counted.
#pragma once

#include "tests/bench/instruction_counter.h"

#include <chrono>
#include <limits>
#include <string>

namespace hyrax::bench {

/// Of one run of a piece of work.
struct Cost {
    double nanoseconds = 0.0;
    double instructions = std::numeric_limits<double>::quiet_NaN();  ///< NaN where not counted.

    Cost per(double units) const { return {nanoseconds / units, instructions / units}; }
};

class Meter {
public:
    /// Spends about so many seconds on each timing.
    explicit Meter(double seconds_per_cell, InstructionCounter counter = {}, bool timed = true)
        : seconds_per_cell_(seconds_per_cell), counter_(std::move(counter)), timed_(timed) {}

    /// The fastest of some samples, so that other load of the machine falls out of the figure.
    Cost measure(const Work& work);

private:
    double seconds_per_cell_;
    InstructionCounter counter_;
    bool timed_;
};

/// The median of single runs that each find the processor's caches full of something else, as a
/// frame does that comes every 16 ms.
double cold_nanoseconds(const Work& work);

/// Says on stderr every other second how far a long run has come.
class Progress {
public:
    Progress(std::string what, std::size_t total) : what_(std::move(what)), total_(total) {}
    void step();

private:
    std::string what_;
    std::size_t total_;
    std::size_t done_ = 0;
    std::chrono::steady_clock::time_point said_ = std::chrono::steady_clock::now();
};

/// Keeps the compiler from leaving out what computes this number.
void keep(double number);

/// Three digits in 10 characters, "-" for NaN.
std::string short_number(double number);

}  // namespace hyrax::bench
