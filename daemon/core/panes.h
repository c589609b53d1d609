// SPDX-License-Identifier: MIT
// Plans the windows of the overlay and what of them has to be drawn anew. Pure: values in, values
// out; a desktop carries it out.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/core/frame.h"
#include "physics/geometry.h"
#include "physics/ticks.h"

#include <cstddef>
#include <span>
#include <vector>

namespace hyrax {

/// A window of the overlay: the part of one monitor that holds all sprites on it.
struct Pane {
    Rect monitor;     ///< Bounds of its monitor, by which a pane is known.
    Rect area;        ///< What the window covers: never empty, within the monitor.
    Rect shows;       ///< Bounding box of the sprites at the latest plan.
    Ticks since = 0;  ///< Start of the span after which the area may shrink.
    Rect first;       ///< Bounding box of the sprites at `since`.
    Size largest;     ///< The greatest width and height of such boxes since then.

    bool operator==(const Pane&) const = default;
};

/// One pane for each monitor that shows a part of a sprite, in the order of the monitors; none on
/// those whose bounds are kept free. A pane keeps its size, for which the system has built a
/// surface, and slides after its sprites when they leave it; it grows when they no longer fit, and
/// shrinks when it was too large for a second.
std::vector<Pane> plan_panes(
    std::span<const Monitor> monitors,
    std::span<const Rect> sprites,
    std::span<const Pane> before,
    Ticks now,
    std::span<const Rect> kept_free = {}
);

/// When to plan again although no sprite moves, because a pane may shrink then; `never` if none.
Ticks next_plan(std::span<const Pane> panes);

/// Where the frame's sprites stand, in their order.
std::vector<Rect> places_of(const Frame& frame);

/// The old and the new place of each sprite that differs between two frames.
std::vector<Rect> changed_places(const Frame& before, const Frame& after);

/// What presenting in several calls costs on a system.
struct PresentCost {
    std::size_t most_calls = 8;  ///< > 0
    long long call_px = 0;       ///< Pixels that could be presented for the price of a call.
    /// A cluster that holds so much of the area becomes the area.
    int whole_percent = 100;
};

/// Covers the parts of the places that lie in `area` with few rectangles that hold few other
/// pixels. They may overlap.
std::vector<Rect> dirty_clusters(
    std::span<const Rect> places, const Rect& area, const PresentCost& cost
);

}  // namespace hyrax
