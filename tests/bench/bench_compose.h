// SPDX-License-Identifier: MIT
// What it takes to draw a crowd: each kernel of the blitter, and GDI+ where it is.
#pragma once

#include "daemon/core/blit.h"
#include "daemon/core/frame.h"
#include "tests/bench/meter.h"

#include <functional>
#include <iosfwd>

namespace hyrax::bench {

/// Milliseconds for 100 sprites of 128x128 in a pane of 1920x1080, as drawn and at opacity 200,
/// over whatever is there and after the whole pane was erased; and as frame after frame is drawn,
/// where only the places of the one before are erased, with warm and with cold caches. With cold
/// ones also what only erasing those places takes: the memory's share, whoever draws.
void compose_crowd(std::ostream& table, std::ostream& csv, Meter& meter);

/// Draws the frame into a target at the origin.
using Composer = std::function<void(const PixelView& target, const Frame& frame)>;

/// Empty where there is no GDI+.
Composer gdiplus_composer();

}  // namespace hyrax::bench
