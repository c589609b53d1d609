// SPDX-License-Identifier: MIT
#include "daemon/core/arena.h"

#include "daemon/core/check.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace hyrax {
namespace {

// Distance along one axis from a coordinate to the interval [low, high].
double gap(double value, double low, double high) {
    return std::max({0.0, low - value, value - high});
}

double distance_squared(Vec2 point, const Rect& box) {
    const double dx = gap(point.x, box.x, box.right());
    const double dy = gap(point.y, box.y, box.bottom());
    return dx * dx + dy * dy;
}

}  // namespace

Arena::Arena(const std::vector<Monitor>& monitors, FloorEdge floor) {
    for (const Monitor& monitor : monitors) {
        Rect box = monitor.bounds;
        if (floor == FloorEdge::work_area) {
            const Rect work = intersection(monitor.bounds, monitor.work);
            if (!work.empty()) {
                box = work;
            }
        }
        if (!box.empty()) {
            boxes_.push_back(box);
            scales_.push_back(monitor.scale);
        }
    }
}

Rect Arena::bounds() const {
    Rect all;
    for (const Rect& box : boxes_) {
        all = united(all, box);
    }
    return all;
}

std::size_t Arena::index_near(Vec2 point) const {
    HYRAX_CHECK(!boxes_.empty());
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const double distance = distance_squared(point, boxes_[i]);
        if (distance < least) {
            nearest = i;
            least = distance;
        }
    }
    return nearest;
}

bool Arena::has_mixed_scales() const {
    return std::ranges::adjacent_find(scales_, std::ranges::not_equal_to()) != scales_.end();
}

std::size_t Arena::screen_of(Vec2 feet, std::size_t former) const {
    constexpr double hysteresis = 16.0;  // [px]
    if (former < boxes_.size() &&
        distance_squared(feet, boxes_[former]) < hysteresis * hysteresis) {
        return former;
    }
    return index_near(feet);
}

}  // namespace hyrax
