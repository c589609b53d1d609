// SPDX-License-Identifier: MIT
// What a file may be called on every system.
#pragma once

#include <string_view>

namespace hyrax {

/// Windows opens a device for these names, whatever follows the first dot: con, nul, com1 ...
bool names_device(std::string_view file_name);

}  // namespace hyrax
