// SPDX-License-Identifier: MIT
#include "daemon/win32/look_schedule.h"

#include <doctest/doctest.h>

#include <vector>

using namespace hyrax;
using hyrax::win32::LookSchedule;

namespace {

constexpr Ticks ms = ticks_per_ms;

std::vector<Ticks> looks_until(LookSchedule& schedule, Ticks end) {
    std::vector<Ticks> looks;
    while (schedule.due() <= end) {
        looks.push_back(schedule.due() / ms);
        schedule.looked(schedule.due());
    }
    return looks;
}

}  // namespace

TEST_CASE("without a hint and a period nobody looks") {
    const LookSchedule schedule;
    CHECK(schedule.due() == never);
}

TEST_CASE("a hint means three looks; a newer one begins anew") {
    LookSchedule schedule;
    schedule.hint(100 * ms);
    CHECK(looks_until(schedule, 200 * ms) == std::vector<Ticks>{100});
    schedule.hint(200 * ms);
    CHECK(looks_until(schedule, 60'000 * ms) == std::vector<Ticks>{200, 450, 1200});
    CHECK(schedule.due() == never);
}

TEST_CASE("a period counts from the latest look and can end") {
    LookSchedule schedule;
    schedule.set_period(2'000 * ms, 0);
    schedule.set_period(2'000 * ms, 500 * ms);
    CHECK(looks_until(schedule, 4'000 * ms) == std::vector<Ticks>{2'000, 4'000});
    schedule.hint(5'000 * ms);
    CHECK(looks_until(schedule, 8'000 * ms) == std::vector<Ticks>{5'000, 5'250, 6'000, 8'000});
    schedule.set_period(never, 8'000 * ms);
    CHECK(schedule.due() == never);
}
