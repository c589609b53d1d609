// SPDX-License-Identifier: MIT
// GDI+ as the painter of text.
#pragma once

#include "daemon/core/speech.h"

namespace hyrax::win32 {

/// Needs a GdiplusSession while it is called; may be called on any one thread at a time.
TextPainter make_gdiplus_text_painter();

}  // namespace hyrax::win32
