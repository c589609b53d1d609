// SPDX-License-Identifier: MIT
// What of the desktop has to be drawn anew from one frame to the next. Pure.
#pragma once

#include "daemon/core/frame.h"
#include "physics/geometry.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace hyrax {

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

/// Calls that each of so many panes (> 0) may take: 16 in all, but at least two and at most eight
/// each.
constexpr std::size_t calls_for_each_of(std::size_t panes) {
    return std::clamp<std::size_t>(16 / panes, 2, 8);
}

/// Covers the parts of the places that lie in `area` with few rectangles that hold few other
/// pixels. They may overlap.
std::vector<Rect> dirty_clusters(
    std::span<const Rect> places, const Rect& area, const PresentCost& cost
);

}  // namespace hyrax
