// SPDX-License-Identifier: MIT
// GDI+ as the reference that the blitter is compared with.
#pragma once

#include "daemon/core/blit.h"
#include "daemon/core/frame.h"
#include "physics/geometry.h"

namespace hyrax::win32 {

/// What compose() of blit.h does, drawn by GDI+ alone; each channel of each sprite may differ by 1.
/// Needs a GdiplusSession.
void compose_with_gdiplus(
    const PixelView& target, Point origin, const Rect& area, const Frame& frame
);

}  // namespace hyrax::win32
