// SPDX-License-Identifier: MIT
#include "daemon/core/check.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace hyrax {
namespace {

void print_and_abort(const char* condition, const std::source_location& where) {
    std::fprintf(stderr, "%s:%u: broken check: %s\n", where.file_name(), where.line(), condition);
    std::abort();
}

// The one mutable global: asserts must reach their handler from anywhere.
CheckHandler current_handler = print_and_abort;

}  // namespace

CheckHandler set_check_handler(CheckHandler handler) {
    return std::exchange(current_handler, handler);
}

void report_broken_check(const char* condition, const std::source_location& where) {
    current_handler(condition, where);
}

}  // namespace hyrax
