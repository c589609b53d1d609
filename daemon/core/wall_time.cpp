// SPDX-License-Identifier: MIT
#include "daemon/core/wall_time.h"

#include <fmt/format.h>

namespace hyrax {
namespace {

constexpr std::int64_t hour = 3600;
constexpr std::int64_t day = 24 * hour;

std::int64_t second_of_day(std::int64_t local_seconds) {
    return (local_seconds % day + day) % day;
}

}  // namespace

std::int64_t seconds_until_tomorrow(WallTime now) {
    constexpr std::int64_t morning = 6 * hour;
    const std::int64_t since_midnight = second_of_day(now.seconds + now.offset);
    const std::int64_t wait = (morning - since_midnight + day) % day;
    return wait < hour ? wait + day : wait;
}

std::string clock_text(WallTime now, std::int64_t at_seconds) {
    const std::int64_t since_midnight = second_of_day(at_seconds + now.offset);
    return fmt::format("{:02}:{:02}", since_midnight / hour, since_midnight % hour / 60);
}

}  // namespace hyrax
