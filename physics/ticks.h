// SPDX-License-Identifier: MIT
// Time as the whole program keeps it: integer nanoseconds of a monotonic clock.
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>

namespace hyrax {

/// A moment or a span [ns]. Only differences become floating point.
using Ticks = std::int64_t;

/// No deadline: wait for input alone.
inline constexpr Ticks never = std::numeric_limits<Ticks>::max();

inline constexpr Ticks ticks_per_second = 1'000'000'000;
inline constexpr Ticks ticks_per_ms = 1'000'000;

constexpr double to_seconds(Ticks span) {
    return static_cast<double>(span) / static_cast<double>(ticks_per_second);
}

/// From one moment to another: 0 if that lies before it, `never` if the span is too long to say.
constexpr Ticks span_between(Ticks from, Ticks to) {
    if (to <= from) {
        return 0;
    }
    // Unsigned, so that no pair of moments overflows.
    const auto span = static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from);
    return span < static_cast<std::uint64_t>(never) ? static_cast<Ticks>(span) : never;
}

/// Rounds to the nearest tick. [seconds] must lie within +-292 years.
constexpr Ticks from_seconds(double seconds) {
    const double ns = seconds * static_cast<double>(ticks_per_second);
    return static_cast<Ticks>(ns < 0.0 ? ns - 0.5 : ns + 0.5);
}

}  // namespace hyrax
