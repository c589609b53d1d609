// SPDX-License-Identifier: MIT
#include "daemon/core/arena.h"

#include "daemon/core/check.h"

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

const Rect& Arena::box_near(Vec2 point) const {
    HYRAX_CHECK(!boxes_.empty());
    const Rect* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Rect& box : boxes_) {
        const double distance = distance_squared(point, box);
        if (nearest == nullptr || distance < least) {
            nearest = &box;
            least = distance;
        }
    }
    return *nearest;
}

}  // namespace hyrax
