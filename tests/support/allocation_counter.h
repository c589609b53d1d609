// SPDX-License-Identifier: MIT
// Counts what a test program takes from the free store.
#pragma once

#include <cstddef>

namespace hyrax {

/// Calls of operator new since the program began, in all threads. Needs allocation_counter.cpp,
/// which replaces the operator.
std::size_t allocations();

}  // namespace hyrax
