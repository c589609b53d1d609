// SPDX-License-Identifier: MIT
// Every frame of every pet as CSV: for tests, and for people who want to see the numbers.
#pragma once

#include "daemon/core/engine.h"
#include "daemon/core/result.h"
#include "physics/ticks.h"

#include <filesystem>
#include <fstream>

namespace hyrax {

class Trace {
public:
    /// Replaces the file and writes the head line.
    [[nodiscard]] static Result<Trace> open(const std::filesystem::path& path);

    /// One line for each pet: time [s] since the first frame, index and generation, kind, position
    /// of the box's top-left corner [px], velocity [px/s], motion. 17 digits: bits survive.
    void write(const Engine& engine, Ticks now);

private:
    explicit Trace(std::ofstream file) : file_(std::move(file)) {}

    std::ofstream file_;
    Ticks first_ = never;
};

}  // namespace hyrax
