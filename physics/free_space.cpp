// SPDX-License-Identifier: MIT
#include "physics/free_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyrax {
namespace {

// Scaled desktops leave rounding gaps of one pixel between monitors.
constexpr int least_gap = 2;

// More than roundings make of a way across any desktop, and far less than can be seen [px].
constexpr double rounding = 1e-9;

bool overlap(int low_a, int high_a, int low_b, int high_b) {
    return low_a < high_b && low_b < high_a;
}

void close_gaps(std::vector<Rect>& rooms) {
    const auto is_small = [](int gap) { return gap > 0 && gap < least_gap; };
    for (Rect& room : rooms) {
        for (const Rect& other : rooms) {
            if (overlap(room.y, room.bottom(), other.y, other.bottom()) &&
                is_small(other.x - room.right())) {
                room.width = other.x - room.x;
            }
            if (overlap(room.x, room.right(), other.x, other.right()) &&
                is_small(other.y - room.bottom())) {
                room.height = other.y - room.y;
            }
        }
    }
}

struct Interval {
    int low;
    int high;
    bool operator==(const Interval&) const = default;
};

// What the rooms leave of [low, high] in the slab from `top` to `bottom`, which no edge crosses.
std::vector<Interval> gaps_in_slab(const std::vector<Rect>& rooms, Interval slab, Interval whole) {
    std::vector<Interval> filled;
    for (const Rect& room : rooms) {
        if (room.y <= slab.low && room.bottom() >= slab.high) {
            filled.push_back({room.x, room.right()});
        }
    }
    std::ranges::sort(filled, {}, &Interval::low);
    std::vector<Interval> gaps;
    int at = whole.low;
    for (const Interval& part : filled) {
        if (part.low > at) {
            gaps.push_back({at, part.low});
        }
        at = std::max(at, part.high);
    }
    if (at < whole.high) {
        gaps.push_back({at, whole.high});
    }
    return gaps;
}

// The complement of the rooms inside their bounding box, cut into rectangles as high as possible.
std::vector<Rect> solids_between(const std::vector<Rect>& rooms, const Rect& bounds) {
    std::vector<int> edges;
    for (const Rect& room : rooms) {
        edges.push_back(room.y);
        edges.push_back(room.bottom());
    }
    std::ranges::sort(edges);
    edges.erase(std::ranges::unique(edges).begin(), edges.end());

    std::vector<Rect> solids;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        const Interval slab{edges[i], edges[i + 1]};
        for (const Interval& gap : gaps_in_slab(rooms, slab, {bounds.x, bounds.right()})) {
            const auto above = std::ranges::find_if(solids, [&](const Rect& solid) {
                return solid.bottom() == slab.low && solid.x == gap.low &&
                       solid.right() == gap.high;
            });
            if (above != solids.end()) {
                above->height = slab.high - above->y;
            } else {
                solids.push_back({gap.low, slab.low, gap.high - gap.low, slab.high - slab.low});
            }
        }
    }
    return solids;
}

std::vector<Obstacle> obstacles_for(const std::vector<Rect>& rooms, Size box) {
    Rect bounds;
    for (const Rect& room : rooms) {
        bounds = united(bounds, room);
    }
    std::vector<Obstacle> obstacles{
        {.right = static_cast<double>(bounds.x)},
        {.left = static_cast<double>(bounds.right() - box.width)},
        {.bottom = static_cast<double>(bounds.y)},
        {.top = static_cast<double>(bounds.bottom() - box.height)},
    };
    for (const Rect& solid : solids_between(rooms, bounds)) {
        obstacles.push_back(
            {static_cast<double>(solid.x - box.width),
             static_cast<double>(solid.y - box.height),
             static_cast<double>(solid.right()),
             static_cast<double>(solid.bottom())}
        );
    }
    return obstacles;
}

bool is_in(Vec2 point, std::span<const Obstacle> obstacles) {
    return std::ranges::any_of(obstacles, [point](const Obstacle& obstacle) {
        return obstacle.contains(point);
    });
}

// Every nearest point has each coordinate either from the point or from a side.
std::optional<Vec2> nearest_free(Vec2 point, std::span<const Obstacle> obstacles) {
    if (!is_in(point, obstacles)) {
        return point;
    }
    std::vector<double> xs{point.x};
    std::vector<double> ys{point.y};
    for (const Obstacle& obstacle : obstacles) {
        for (const double x : {obstacle.left, obstacle.right}) {
            if (std::isfinite(x)) {
                xs.push_back(x);
            }
        }
        for (const double y : {obstacle.top, obstacle.bottom}) {
            if (std::isfinite(y)) {
                ys.push_back(y);
            }
        }
    }
    std::optional<Vec2> best;
    double least = infinity;
    for (const double y : ys) {
        for (const double x : xs) {
            const double distance = std::hypot(x - point.x, y - point.y);
            const bool nearer = distance < least || (distance == least && best && y < best->y);
            if (nearer && !is_in({x, y}, obstacles)) {
                best = {x, y};
                least = distance;
            }
        }
    }
    return best;
}

}  // namespace

FreeSpace::FreeSpace(std::vector<Obstacle> obstacles) : obstacles_(std::move(obstacles)) {
    for (const Obstacle& o : obstacles_) {
        const auto add = [](std::vector<Barrier>& sides, const Barrier& side) {
            if (std::isfinite(side.at)) {
                sides.push_back(side);
            }
        };
        add(right_walls_, {o.left, o.top, o.bottom});
        add(left_walls_, {o.right, o.top, o.bottom});
        add(floors_, {o.top, o.left, o.right});
        add(ceilings_, {o.bottom, o.left, o.right});
    }
}

FreeSpace FreeSpace::box(double left, double top, double right, double bottom) {
    FreeSpace space({{.right = left}, {.left = right}, {.bottom = top}, {.top = bottom}});
    space.is_box_ = true;
    return space;
}

FreeSpace FreeSpace::among(std::vector<Rect> rooms, Size box) {
    std::erase_if(rooms, [](const Rect& room) { return room.empty(); });
    if (rooms.empty()) {
        return {};
    }
    close_gaps(rooms);
    const Rect& largest = *std::ranges::max_element(rooms, {}, &Rect::area);
    FreeSpace space(obstacles_for(rooms, box));
    if (!nearest_free(
            {static_cast<double>(largest.x), static_cast<double>(largest.y)}, space.obstacles_
        )) {
        const Size fitting{
            std::min(box.width, largest.width), std::min(box.height, largest.height)
        };
        space = FreeSpace(obstacles_for(rooms, fitting));
        space.overhang_ = {(box.width - fitting.width) / 2.0, (box.height - fitting.height) / 2.0};
    }
    space.is_box_ = space.obstacles_.size() == 4;
    return space;
}

FreeSpace FreeSpace::with_ledges(std::span<const Ledge> ledges, Size box) const {
    FreeSpace space = *this;
    space.floors_.erase(space.floors_.end() - ledge_count_, space.floors_.end());
    for (const Ledge& ledge : ledges) {
        // A pinned box moves as if it were smaller.
        space.floors_.push_back(
            {ledge.y - (box.height - 2.0 * overhang_.y),
             ledge.left - (box.width - 2.0 * overhang_.x),
             static_cast<double>(ledge.right)}
        );
    }
    space.ledge_count_ = std::ssize(ledges);
    space.is_box_ = obstacles_.size() == 4 && ledges.empty();
    return space;
}

Vec2 FreeSpace::lifted(double from_y, Vec2 to) const {
    for (const Barrier& ledge : ledges()) {
        if (from_y <= ledge.at && to.y > ledge.at && to.y <= ledge.at + rounding &&
            to.x > ledge.low && to.x < ledge.high) {
            to.y = ledge.at;
        }
    }
    return to;
}

Vec2 FreeSpace::moved_inside(Vec2 point) const {
    // From farther away than this, distances would overflow or be all the same.
    constexpr double far = 1e9;
    const Vec2 near{std::clamp(point.x, -far, far), std::clamp(point.y, -far, far)};
    return nearest_free(near, obstacles_).value_or(near);
}

std::optional<Support> FreeSpace::support(Vec2 point) const {
    std::optional<Support> found;
    for (bool grows = true; grows;) {
        grows = false;
        for (const Barrier& floor : floors_) {
            if (floor.at != point.y) {
                continue;
            }
            if (!found) {
                if (point.x > floor.low && point.x < floor.high) {
                    found = {floor.low, floor.high};
                    grows = true;
                }
            } else if (floor.low <= found->right && floor.high >= found->left &&
                       (floor.low < found->left || floor.high > found->right)) {
                found->left = std::min(found->left, floor.low);
                found->right = std::max(found->right, floor.high);
                grows = true;
            }
        }
    }
    return found;
}

Support FreeSpace::corridor(Vec2 point) const {
    Support walls{-infinity, infinity};
    for (const Barrier& wall : left_walls_) {
        if (point.y > wall.low && point.y < wall.high && wall.at <= point.x) {
            walls.left = std::max(walls.left, wall.at);
        }
    }
    for (const Barrier& wall : right_walls_) {
        if (point.y > wall.low && point.y < wall.high && wall.at >= point.x) {
            walls.right = std::min(walls.right, wall.at);
        }
    }
    return walls;
}

}  // namespace hyrax
