// SPDX-License-Identifier: MIT
// Where pets may be: the union of the monitors.
#pragma once

#include "physics/free_space.h"
#include "physics/geometry.h"

#include <string>
#include <vector>

namespace hyrax {

/// A screen as the desktop reports it. Rectangles in physical pixels of the virtual desktop.
struct Monitor {
    Rect bounds;
    Rect work;  ///< Without the taskbar.
    bool primary = false;
    std::string name;  ///< For people; may change when the machine sleeps.
    std::string id{};  ///< Of the device, the same at every start; may be empty.
    bool operator==(const Monitor&) const = default;
};

/// What settings remember a monitor by.
inline const std::string& identity(const Monitor& monitor) {
    return monitor.id.empty() ? monitor.name : monitor.id;
}

/// What pets stand on at the bottom of a monitor.
enum class FloorEdge { work_area, screen };

/// One box for each monitor. Empty only before the first monitor is known.
class Arena {
public:
    Arena() = default;
    /// Monitors with an empty rectangle are left out.
    Arena(const std::vector<Monitor>& monitors, FloorEdge floor);

    const std::vector<Rect>& boxes() const { return boxes_; }
    bool empty() const { return boxes_.empty(); }
    /// Where a pet of this size may be: the union of the boxes has no walls inside.
    FreeSpace space_for(Size size) const { return FreeSpace::among(boxes_, size); }
    /// Bounding box of all boxes; may hold places that no monitor shows.
    Rect bounds() const;
    /// The box that holds the point, else the nearest one. The arena must not be empty.
    const Rect& box_near(Vec2 point) const;

    bool operator==(const Arena&) const = default;

private:
    std::vector<Rect> boxes_;
};

}  // namespace hyrax
