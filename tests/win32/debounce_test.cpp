// SPDX-License-Identifier: MIT
#include "daemon/win32/debounce.h"

#include <doctest/doctest.h>

using namespace hyrax;
using hyrax::win32::Debounce;

namespace {

constexpr Ticks ms = ticks_per_ms;

}  // namespace

TEST_CASE("without a hint nothing is due") {
    Debounce debounce(200 * ms, 2000 * ms);
    CHECK(debounce.due() == never);
    CHECK_FALSE(debounce.take(1'000'000 * ms));
}

TEST_CASE("a burst of hints fires once, when it is quiet") {
    Debounce debounce(200 * ms, 2000 * ms);
    for (Ticks now = 0; now <= 500 * ms; now += 100 * ms) {
        debounce.hint(now);
        CHECK_FALSE(debounce.take(now + 99 * ms));
    }
    CHECK(debounce.due() == 700 * ms);
    CHECK_FALSE(debounce.take(699 * ms));
    CHECK(debounce.take(700 * ms));
    CHECK_FALSE(debounce.take(701 * ms));
    CHECK(debounce.due() == never);
}

TEST_CASE("hints without end cannot put it off for ever") {
    Debounce debounce(200 * ms, 2000 * ms);
    Ticks now = 0;
    while (!debounce.take(now)) {
        debounce.hint(now);
        now += 50 * ms;
        REQUIRE(now <= 2100 * ms);
    }
    CHECK(now == 2000 * ms);
}
