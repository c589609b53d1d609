// SPDX-License-Identifier: MIT
// How one pane changes its area with the sprites it shows. Pure.
#pragma once

#include "daemon/core/panes.h"
#include "physics/geometry.h"

namespace hyrax {

/// Of a new pane: around the box, with room to move, within the limits, which hold the box.
Rect fitted_area(const Rect& box, const Rect& limits);

/// The area once `pane.shows` has left it: it slides, or grows if that is too long. Within the
/// monitor.
Rect followed_area(const Pane& pane);

/// A part of the area that is enough for what the pane has shown since `pane.since` and shows now,
/// if a quarter can be gained: a new surface and its full redraw are paid with that. Else the area.
Rect shrunk_area(const Pane& pane);

}  // namespace hyrax
