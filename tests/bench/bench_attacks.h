// SPDX-License-Identifier: MIT
// What hostile scripts do to the daemon's frames.
#pragma once

#include <filesystem>

namespace hyrax {

/// 50 pets at 60 Hz on the real clock, for `seconds` with nobody, with each of the hostile scripts
/// in tests/script/attacks, and with a hundred scripts of which ten are hostile; a line for each:
/// late frames, the longest frame, what memory has grown by. False if a script made frames late, or
/// this process grow.
bool measure_attacks(const std::filesystem::path& program, double seconds);

}  // namespace hyrax
