// SPDX-License-Identifier: MIT
#include "daemon/win32/clock.h"

#include <doctest/doctest.h>

using namespace hyrax::win32;
using namespace std::chrono_literals;

TEST_CASE("clock: processor time counts work, not sleep") {
    const auto before = thread_processor_time();
    ::Sleep(300);
    CHECK(thread_processor_time() - before < 200ms);
    // Ends by the test run's time limit if the clock stands still.
    while (thread_processor_time() - before < 50ms) {}
}
