// SPDX-License-Identifier: MIT
#include "daemon/win32/monitor_watch.h"

#include <doctest/doctest.h>

#include <vector>

using namespace hyrax;
using hyrax::win32::MonitorWatch;

namespace {

constexpr Ticks ms = ticks_per_ms;

std::vector<Monitor> screens(int count) {
    std::vector<Monitor> result;
    for (int i = 0; i < count; ++i) {
        const Rect bounds{i * 1920, 0, 1920, 1080};
        result.push_back({.bounds = bounds, .work = bounds, .primary = i == 0, .name = "screen"});
    }
    return result;
}

/// Reads when it is due, as the desktop does; how many changes were seen until then.
int run_until(MonitorWatch& watch, const std::vector<Monitor>& reading, Ticks end) {
    int changes = 0;
    while (watch.due() <= end) {
        changes += watch.settle(reading, watch.due()) ? 1 : 0;
    }
    return changes;
}

}  // namespace

TEST_CASE("nothing is read while nothing happens") {
    const MonitorWatch watch(screens(1), 0);
    CHECK(watch.due() == never);
}

TEST_CASE("a storm of hints is one change, seen twice") {
    MonitorWatch watch(screens(1), 0);
    for (int i = 0; i < 50; ++i) {
        watch.hint(i * 20 * ms);
    }
    CHECK(watch.due() == (980 + 300) * ms);
    CHECK(run_until(watch, screens(2), 60'000 * ms) == 1);
    CHECK(watch.current() == screens(2));
    CHECK(watch.due() == never);
}

TEST_CASE("a reading that does not last is no change") {
    MonitorWatch watch(screens(2), 0);
    watch.hint(0);
    CHECK_FALSE(watch.settle(screens(1), watch.due()));
    CHECK_FALSE(watch.settle(screens(2), watch.due()));
    CHECK(watch.due() == never);
    CHECK(watch.current() == screens(2));
}

TEST_CASE("no monitors at all is not believed") {
    MonitorWatch watch(screens(1), 0);
    watch.hint(0);
    CHECK(run_until(watch, {}, 5'000 * ms) == 0);
    CHECK(watch.current() == screens(1));
    CHECK(run_until(watch, screens(1), 10'000 * ms) == 0);
    CHECK(watch.due() == never);
}

TEST_CASE("a start without monitors asks until there are some") {
    MonitorWatch watch({}, 0);
    CHECK(run_until(watch, {}, 3'000 * ms) == 0);
    CHECK(run_until(watch, screens(1), 10'000 * ms) == 1);
    CHECK(watch.current() == screens(1));
}

TEST_CASE("after a change there are a few more looks, since screens come one by one") {
    MonitorWatch watch(screens(1), 0);
    watch.hint(0);
    CHECK(run_until(watch, screens(2), 1'000 * ms) == 1);
    // Another one comes two seconds later, and nobody tells.
    CHECK(run_until(watch, screens(3), 8'000 * ms) == 1);
    CHECK(watch.current() == screens(3));
    CHECK(run_until(watch, screens(3), 60'000 * ms) == 0);
    CHECK(watch.due() == never);
}

TEST_CASE("after sleep there are a few more looks, for screens that come back late") {
    MonitorWatch watch(screens(2), 0);
    watch.woke_up(0);
    CHECK(run_until(watch, screens(1), 700 * ms) == 1);
    CHECK(watch.due() == (450 + 1'000) * ms);  // after that change
    CHECK(run_until(watch, screens(1), 4'000 * ms) == 0);
    CHECK(run_until(watch, screens(2), 6'000 * ms) == 1);
    CHECK(run_until(watch, screens(2), 60'000 * ms) == 0);
    CHECK(watch.due() == never);
}
