// SPDX-License-Identifier: MIT
// Where a box may be, as places for its top-left corner: the free part of its configuration space.
// A box meets a solid where its corner meets the solid expanded by the box, so that the motion of
// a box among rectangles is the motion of a point among larger rectangles, and edges that two
// monitors share are no obstacles at all. A ledge is the upper side of a solid without the solid:
// the top of a window, which stops what falls and nothing else.
#pragma once

#include "physics/geometry.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace hyrax {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// An open rectangle that the point must not enter [px]; sides may be infinite.
struct Obstacle {
    double left = -infinity;
    double top = -infinity;
    double right = infinity;
    double bottom = infinity;

    bool contains(Vec2 p) const { return p.x > left && p.x < right && p.y > top && p.y < bottom; }
    bool operator==(const Obstacle&) const = default;
};

/// One side of an obstacle: where it lies on the axis that it blocks, and how far it reaches on the
/// other one [px], both ends excluded.
struct Barrier {
    double at = 0.0;
    double low = 0.0;
    double high = 0.0;
    bool operator==(const Barrier&) const = default;
};

/// A floor that is open from below, as the desktop has it [px]. A box stands on it as long as any
/// part of its lower side lies above it: the same rule as for the edge of a monitor.
struct Ledge {
    int left = 0;
    int right = 0;
    int y = 0;
    bool operator==(const Ledge&) const = default;
};

/// A stretch of floor [px], both ends excluded.
struct Support {
    double left = 0.0;
    double right = 0.0;
};

/// Immutable. The default one is unbounded: no walls, no floor.
class FreeSpace {
public:
    FreeSpace() = default;
    explicit FreeSpace(std::vector<Obstacle> obstacles);
    /// One box with walls on all sides: left <= x <= right, top <= y <= bottom.
    static FreeSpace box(double left, double top, double right, double bottom);
    /// The places where a box of this size lies inside the union of the rooms. Gaps between rooms
    /// below 2 px are closed. A box that fits nowhere is pinned: it moves as if it were as wide or
    /// as high as the largest room, and overhang() tells by how much it really is larger.
    static FreeSpace among(std::vector<Rect> rooms, Size box);
    /// The same space for the same box, with these ledges in place of its own. Parts of them that
    /// lie in solids have no effect.
    FreeSpace with_ledges(std::span<const Ledge> ledges, Size box) const;

    std::span<const Obstacle> obstacles() const { return obstacles_; }
    /// Met by moving to the right, to the left, downwards and upwards.
    std::span<const Barrier> right_walls() const { return right_walls_; }
    std::span<const Barrier> left_walls() const { return left_walls_; }
    /// Those of the solids, then the ledges.
    std::span<const Barrier> floors() const { return floors_; }
    std::span<const Barrier> ceilings() const { return ceilings_; }
    std::span<const Barrier> ledges() const {
        return std::span(floors_).last(static_cast<std::size_t>(ledge_count_));
    }
    /// Half of what the box sticks out of the largest room [px], zero for a box that fits:
    /// its top-left corner is the point minus this.
    Vec2 overhang() const { return overhang_; }
    bool contains(Vec2 point) const {
        for (const Obstacle& obstacle : obstacles_) {
            if (obstacle.contains(point)) {
                return false;
            }
        }
        return true;
    }
    /// The nearest place, of two equally near ones the upper. Sides belong to the space; ledges
    /// move nobody.
    Vec2 nearest(Vec2 point) const { return contains(point) ? point : moved_inside(point); }
    /// The floor on which the point lies, across all solids and ledges of this height.
    std::optional<Support> support(Vec2 point) const;
    /// The two walls that face each other at this place, infinite where there is none.
    Support corridor(Vec2 point) const;
    /// `to`, put back onto a ledge that roundings alone have carried it through on a way that began
    /// at the height `from_y`, on the ledge or above it.
    Vec2 above_ledges(double from_y, Vec2 to) const {
        return ledge_count_ == 0 ? to : lifted(from_y, to);
    }
    /// True if the space is one box without ledges: walls are the same at every height, and what
    /// ends a fall does not depend on them.
    bool is_box() const { return is_box_; }

    bool operator==(const FreeSpace&) const = default;

private:
    Vec2 moved_inside(Vec2 point) const;
    Vec2 lifted(double from_y, Vec2 to) const;

    std::vector<Obstacle> obstacles_;
    std::vector<Barrier> right_walls_;
    std::vector<Barrier> left_walls_;
    std::vector<Barrier> floors_;
    std::vector<Barrier> ceilings_;
    std::ptrdiff_t ledge_count_ = 0;
    Vec2 overhang_;
    bool is_box_ = false;
};

}  // namespace hyrax
