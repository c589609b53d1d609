// SPDX-License-Identifier: MIT
// GDI as the painter of text: unlike GDI+ it finds a font on every system.
#pragma once

#include "daemon/core/speech.h"

namespace hyrax::win32 {

/// May be called on any one thread at a time.
TextPainter make_text_painter();

}  // namespace hyrax::win32
