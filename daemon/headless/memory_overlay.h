// SPDX-License-Identifier: MIT
// The overlay without windows: the planners of panes.h, carried out on pixels in memory.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/core/dirty.h"
#include "daemon/core/frame.h"
#include "daemon/core/panes.h"
#include "daemon/core/statistics.h"

#include <cstddef>
#include <span>
#include <vector>

namespace hyrax {

/// The frame with its bubbles as its last sprites: for where nobody clicks.
Frame flattened(const Frame& frame);

/// Does for a frame all that the windows' overlay does, but for the system's own part.
class MemoryOverlay {
public:
    /// Shows the frame. Does nothing if it equals the one before and no pane is due to shrink.
    void present(const Frame& frame, std::span<const Monitor> monitors, Ticks now);
    /// When to call present_again(): a pane may shrink. Else `never`.
    Ticks due() const { return next_plan(plan_); }
    /// Shows once more what is there; needs no image.
    void present_again(std::span<const Monitor> monitors, Ticks now);

    /// What stands there (virtual desktop); transparent outside all panes.
    Pixel at(Point point) const;
    const OverlayCounters& counters() const { return counters_; }

private:
    struct Shown {
        std::size_t slot;
        Rect area;                  ///< Empty: everything must be drawn.
        std::vector<Pixel> pixels;  ///< Rows of the area without gaps; never gives room back.
    };

    struct Change {
        const Frame& frame;
        std::span<const Rect> places;
        std::span<const Rect> before;
        PresentCost cost;
    };

    void plan(const PaneScene& scene, Ticks now);
    Shown& shown_in(std::size_t slot);
    void draw(Shown& shown, const Rect& area, const Change& change);
    void crop(Shown& shown, const Rect& area);
    void count(const Rect& presented);

    std::vector<Shown> shown_;
    std::vector<Pane> plan_;
    Frame frame_;
    OverlayCounters counters_;
};

}  // namespace hyrax
