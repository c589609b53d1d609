// SPDX-License-Identifier: MIT
// Programs of random calls of the API: right and wrong ones, in any order, with any arguments.
#pragma once

#include <cstdint>
#include <string>

namespace hyrax {

/// The same seed gives the same program on every system.
std::string random_program(std::uint64_t seed);

}  // namespace hyrax
