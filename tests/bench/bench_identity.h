// SPDX-License-Identifier: MIT
// Whether the batch kernels of this processor give the bits of the document's class.
#pragma once

#include <cstdint>
#include <iosfwd>

namespace hyrax::bench {

/// Compares every kernel with the class over `body_steps` random steps of one body, and writes how
/// many differ in a bit: a table, and the same as CSV. False if any does.
bool identity(std::ostream& table, std::ostream& csv, std::uint64_t body_steps);

}  // namespace hyrax::bench
