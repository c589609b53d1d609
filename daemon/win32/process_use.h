// SPDX-License-Identifier: MIT
// What the system counts for this process.
#pragma once

#include "daemon/core/statistics.h"

namespace hyrax::win32 {

/// Wine 8 tells 0 for handles, GDI and user objects.
ProcessUse process_use();

}  // namespace hyrax::win32
