// SPDX-License-Identifier: MIT
// Where pets may be: the union of the monitors.
#pragma once

#include "physics/free_space.h"
#include "physics/geometry.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace hyrax {

/// A screen as the desktop reports it. Rectangles in physical pixels of the virtual desktop.
struct Monitor {
    Rect bounds;
    Rect work;  ///< Without the taskbar.
    bool primary = false;
    std::string name;      ///< For people; may change when the machine sleeps.
    std::string id{};      ///< Of the device, the same at every start; may be empty.
    double scale = 1.0;    ///< How much larger the system shows things there: DPI / 96.
    int refresh_rate = 0;  ///< [Hz], cut to a whole number; 0 or 1: not known.
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
    /// Floors besides those of the boxes.
    void set_ledges(std::vector<Ledge> ledges) { ledges_ = std::move(ledges); }
    /// Where a pet of this size may be: the union of the boxes has no walls inside.
    FreeSpace space_for(Size size) const {
        const FreeSpace space = FreeSpace::among(boxes_, size);
        return ledges_.empty() ? space : space.with_ledges(ledges_, size);
    }
    /// Bounding box of all boxes; may hold places that no monitor shows.
    Rect bounds() const;
    /// The box that holds the point, else the nearest one. The arena must not be empty.
    const Rect& box_near(Vec2 point) const { return boxes_[index_near(point)]; }
    /// Its index. The arena must not be empty.
    std::size_t index_near(Vec2 point) const;

    /// The scale of the monitor of a box.
    double scale(std::size_t index) const { return scales_[index]; }
    bool has_mixed_scales() const;
    /// The box whose scale counts for feet at this place: `former`, until they are 16 px away from
    /// it, so that feet on a seam do not flicker. The arena must not be empty.
    std::size_t screen_of(Vec2 feet, std::size_t former) const;

    bool operator==(const Arena&) const = default;

private:
    std::vector<Rect> boxes_;
    std::vector<double> scales_;  // By box.
    std::vector<Ledge> ledges_;
};

}  // namespace hyrax
