// SPDX-License-Identifier: MIT
// Where pets may be: one box for each monitor.
#pragma once

#include "physics/geometry.h"

#include <string>
#include <vector>

namespace hyrax {

/// A screen as the desktop reports it. Rectangles in physical pixels of the virtual desktop.
struct Monitor {
    Rect bounds;
    Rect work;  ///< Without the taskbar.
    bool primary = false;
    std::string name;  ///< For people; identity across changes is not promised.
    bool operator==(const Monitor&) const = default;
};

/// What pets stand on at the bottom of a monitor.
enum class FloorEdge { work_area, screen };

/// Boxes with walls on all four sides. Empty only before the first monitor is known.
class Arena {
public:
    Arena() = default;
    /// Monitors with an empty rectangle are left out.
    Arena(const std::vector<Monitor>& monitors, FloorEdge floor);

    const std::vector<Rect>& boxes() const { return boxes_; }
    bool empty() const { return boxes_.empty(); }
    /// Bounding box of all boxes; may hold places that no monitor shows.
    Rect bounds() const;
    /// The box that holds the point, else the nearest one. The arena must not be empty.
    const Rect& box_near(Vec2 point) const;

    bool operator==(const Arena&) const = default;

private:
    std::vector<Rect> boxes_;
};

/// The position nearest to `at` where a box of this size fits into `box`; along an axis on which
/// it is too large it is pinned to the box's left or top edge.
Vec2 fitted(Vec2 at, Size size, const Rect& box);

}  // namespace hyrax
