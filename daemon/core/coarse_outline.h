// SPDX-License-Identifier: MIT
// Fewer steps in the outline of what a window shows, for a system that cuts windows along it.
//
// Wine 8 cuts a layered window to its pixels in every present, into one rectangle for each span of
// each row, and an X server without a compositor then repaints what lies below at a cost that grows
// with the square of their number: 109 ms for 100 hyraxes on 1920x1080. Rows that share an outline
// share their rectangles.
#pragma once

#include "daemon/core/blit.h"

#include <cstddef>

namespace hyrax {

/// Black, and too faint to be seen.
inline constexpr Pixel faint_pixel = 0x01000000U;

/// How many rows may share an outline: 1, exact, for a few sprites; more for crowds, whose fringe
/// of clicks that hit nothing matters least.
int outline_rows(std::size_t sprites);

/// The part with its top and bottom moved outward to bands of so many rows, from `area`'s top on,
/// within the area.
Rect whole_bands(Rect part, const Rect& area, int rows);

/// In each band of so many rows from the target's top on: where a column has a pixel, its
/// transparent ones become faint. `part` must consist of whole bands, except at the target's end.
void coarsen_outline(const PixelView& target, const Rect& part, int rows);

}  // namespace hyrax
