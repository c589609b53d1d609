// SPDX-License-Identifier: MIT
// Plans the windows of the overlay. Pure: values in, values out; a desktop carries it out.
#pragma once

#include "daemon/core/arena.h"
#include "physics/geometry.h"
#include "physics/ticks.h"

#include <cstddef>
#include <span>
#include <vector>

namespace hyrax {

/// A window of the overlay. It lies on one monitor, around sprites that are near each other, and
/// shows whatever is in its area; no two of them overlap.
struct Pane {
    std::size_t slot = 0;  ///< Number of its window, which a later pane may use again.
    Rect monitor;          ///< Bounds of its monitor.
    Rect area;             ///< What the window covers: never empty, within the monitor.
    Rect shows;            ///< Bounding box of its sprites at the latest plan.
    Ticks since = 0;       ///< Start of the span after which the area may shrink.
    Rect first;            ///< Bounding box of the sprites at `since`.
    Size largest;          ///< The greatest width and height of such boxes since then.

    bool operator==(const Pane&) const = default;
};

/// What one more window costs, in pixels that windows cover: about as many as a lone pet's does.
inline constexpr long long window_price = 32'768;

/// What panes are planned for.
struct PaneScene {
    std::span<const Monitor> monitors;
    std::span<const Rect> sprites;
    std::span<const Rect> kept_free{};  ///< Bounds of monitors that must have no pane.
    bool drawable = true;  ///< Sprites can be drawn; else windows only show what they have.
    long long window_px = window_price;  ///< The price of a window on this system.
};

/// The most panes that a monitor has.
inline constexpr std::size_t most_panes = 8;

/// Panes for all that is seen of the sprites, in the order of the monitors. A pane keeps its size,
/// for which the system has built a surface, and slides after its sprites when they leave it.
/// Where they no longer fit, it grows; when it was too large for half a second, it shrinks. In
/// either case it is divided instead if that is a quarter cheaper. Panes that meet, or that cost
/// more than one around both, become one. Where a monitor changes, the panes that still lie in one
/// stay.
std::vector<Pane> plan_panes(const PaneScene& scene, std::span<const Pane> before, Ticks now);

/// Into the order in which windows are to show them, one after the other: a pet that comes into
/// another pane stands there before it leaves the one of `before`.
void sort_for_showing(std::vector<Pane>& panes, std::span<const Pane> before);

/// When to plan again although no sprite moves, because a pane may shrink then; `never` if none.
Ticks next_plan(std::span<const Pane> panes);

}  // namespace hyrax
