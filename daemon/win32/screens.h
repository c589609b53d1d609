// SPDX-License-Identifier: MIT
// The monitors as the system reports them.
#pragma once

#include "daemon/core/arena.h"

#include <vector>

namespace hyrax::win32 {

/// The primary one first; may be empty while screens change or the secure desktop shows.
std::vector<Monitor> read_monitors();

}  // namespace hyrax::win32
