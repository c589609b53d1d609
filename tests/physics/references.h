// SPDX-License-Identifier: MIT
// The 50-digit solutions under tests/golden as values.
#pragma once

#include "physics/contact.h"
#include "physics/ticks.h"

#include <string>
#include <vector>

namespace hyrax::test {

struct ReferenceSample {
    Ticks time = 0;
    Vec2 position;
    Vec2 velocity;
    Mode mode = Mode::air;
    int events = 0;  ///< Up to this time.
};

struct ReferenceScene {
    std::string name;
    std::string family;
    Law law;
    Vec2 position;
    Vec2 velocity;
    FreeSpace space;
    std::vector<ReferenceSample> samples;
};

/// Throws std::runtime_error if the file is not there or not as it should be.
std::vector<ReferenceScene> read_references(const std::string& file);

}  // namespace hyrax::test
