// SPDX-License-Identifier: MIT
// The time of day, for what people count in minutes and mornings. Pets live by Ticks.
#pragma once

#include <cstdint>
#include <string>

namespace hyrax {

struct WallTime {
    std::int64_t seconds = 0;  ///< Since 1970, UTC; jumps when the user sets the clock.
    int offset = 0;            ///< Local time minus UTC at this moment [s].
};

/// To the next six o'clock in the morning, at least an hour. [s]
std::int64_t seconds_until_tomorrow(WallTime now);
/// "14:30": the local time at a moment near `now`.
std::string clock_text(WallTime now, std::int64_t at_seconds);

}  // namespace hyrax
