// SPDX-License-Identifier: MIT
// The system's rectangles as ours.
#pragma once

#include "physics/geometry.h"

#include <windows.h>

namespace hyrax::win32 {

inline Rect rect_from(const RECT& rect) {
    return {
        static_cast<int>(rect.left),
        static_cast<int>(rect.top),
        static_cast<int>(rect.right - rect.left),
        static_cast<int>(rect.bottom - rect.top)
    };
}

}  // namespace hyrax::win32
