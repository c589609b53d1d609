// SPDX-License-Identifier: MIT
// One motion from the command line or a file.
#pragma once

#include "physics/body.h"

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace hyrax::bench {

struct TrajectoryOptions {
    std::vector<double> at{0.0, 0.0};        ///< x, y [px]
    std::vector<double> velocity{0.0, 0.0};  ///< vx, vy [px/s]
    std::vector<double> box;                 ///< left, top, right, bottom of the top-left corner.
    std::string monitors;                    ///< 1920x1080+0+0,... in place of a box.
    std::vector<int> size{128, 128};         ///< Of the body among monitors [px].
    PhysicsConstants constants;
    double reference_rate = default_reference_rate;
    std::string integrator = "event_driven";
    double frame = 1.0 / 60.0;  ///< Of all integrators but event_driven [s].
    std::vector<double> times;  ///< [s]
    double every = 0.1;         ///< Without `times` [s].
    double until = 5.0;         ///< Without `times` [s].
};

/// Replaces what a JSON file names, with the same names as on the command line and the names of
/// config.json's constants. Throws std::runtime_error that says what is wrong.
void read_scene(const std::filesystem::path& file, TrajectoryOptions& options);

/// Position, velocity, mode and number of contacts so far at the times, as CSV with 17 digits. A
/// time between two frames is a frame of its own for all integrators but event_driven.
/// Throws std::runtime_error that says what is wrong with the options.
void trajectory(std::ostream& csv, const TrajectoryOptions& options);

}  // namespace hyrax::bench
