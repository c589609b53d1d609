// SPDX-License-Identifier: MIT
// What /proc tells of this process.
#pragma once

#include "daemon/core/statistics.h"

namespace hyrax {

/// GDI and user objects stay 0: there are none.
ProcessUse process_use();

}  // namespace hyrax
