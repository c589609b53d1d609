// SPDX-License-Identifier: MIT
// Bugs, as opposed to failures: a broken promise between two pieces of this program.
#pragma once

#include <source_location>

namespace hyrax {

/// Called with the broken condition. The default prints it and aborts.
using CheckHandler = void (*)(const char* condition, const std::source_location& where);

/// Replaces the handler (tests, shipped programs) and returns the former one. Not thread-safe.
CheckHandler set_check_handler(CheckHandler handler);

void report_broken_check(
    const char* condition, const std::source_location& where = std::source_location::current()
);

}  // namespace hyrax

#define HYRAX_CHECK(condition) \
    ((condition) ? static_cast<void>(0) : ::hyrax::report_broken_check(#condition))
