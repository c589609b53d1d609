// SPDX-License-Identifier: MIT
// What a running daemon has asked of the machine: for tests and measurements.
#pragma once

#include "daemon/core/result.h"
#include "physics/ticks.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace hyrax {

/// What the overlay asked of the system since the start.
struct OverlayCounters {
    std::uint64_t frames = 0;    ///< Frames that differed from the one before.
    std::uint64_t presents = 0;  ///< Calls that show pixels; each has its own price.
    std::uint64_t bytes = 0;     ///< In the rectangles that these calls presented.
    std::uint64_t resizes = 0;   ///< Of panes: the system makes a new surface for each.
    std::uint64_t failures = 0;  ///< Of presents.
};

struct DesktopCounters {
    OverlayCounters overlay;
    std::uint64_t wakeups = 0;        ///< How often wait() slept and was woken.
    std::uint64_t timer_wakeups = 0;  ///< Those of them because a deadline had come.
    Ticks first_frame = never;        ///< When the first pet was shown, by the desktop's clock.
};

/// What the process holds now; 0 where the system does not tell.
struct ProcessUse {
    std::uint64_t gdi_objects = 0;
    std::uint64_t user_objects = 0;
    std::uint64_t handles = 0;         ///< Of the kernel: files, events, threads.
    std::uint64_t private_bytes = 0;   ///< Nobody else has them.
    std::uint64_t resident_bytes = 0;  ///< In memory at this moment, shared libraries included.
};

struct Statistics {
    Ticks now = 0;  ///< By the desktop's clock.
    std::size_t pets = 0;
    std::size_t moving = 0;
    DesktopCounters desktop;
    ProcessUse process;
};

/// One JSON object on one line, with a line feed. `unix_time` [s since 1970] belongs to
/// Statistics::now; the first frame is told in it, too, or null without one.
std::string json_line(const Statistics& statistics, double unix_time);

/// Adds a line for this moment to the end of the file, which is made if need be.
[[nodiscard]] Result<void> append_statistics(
    const std::filesystem::path& file, const Statistics& statistics
);

}  // namespace hyrax
