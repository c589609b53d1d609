// SPDX-License-Identifier: MIT
// How much larger the user wants things on a monitor.
#pragma once

#include <windows.h>

namespace hyrax::win32 {

/// Effective DPI / 96: 1.5 for a monitor at 150 %. 1 where the system cannot tell.
double monitor_scale(HMONITOR monitor);

}  // namespace hyrax::win32
