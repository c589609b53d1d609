// SPDX-License-Identifier: MIT
#include "daemon/core/pane_shape.h"

#include <algorithm>

namespace hyrax {

namespace {

/// Lengths of panes are multiples of this [px], or the monitor's.
constexpr int grid = 64;
/// Free pixels around the sprites [px]: a pane is not changed for the first steps of a walk.
constexpr int margin = 32;
/// Room that growth adds at least [px], for half a second of a run apart.
constexpr int reach = 256;

/// One axis of a rectangle [px].
struct Span {
    int low;
    int length;

    int high() const { return low + length; }
    bool contains(Span other) const { return low <= other.low && other.high() <= high(); }
};

Span across(const Rect& rect) {
    return {rect.x, rect.width};
}

Span down(const Rect& rect) {
    return {rect.y, rect.height};
}

int across(Size size) {
    return size.width;
}

int down(Size size) {
    return size.height;
}

/// Plans each axis for itself.
Rect both_axes(auto plan, const auto&... parts) {
    const Span x = plan(across(parts)...);
    const Span y = plan(down(parts)...);
    return {x.low, y.low, x.length, y.length};
}

/// What sprites of this length need in order to move a little without leaving the pane. The more
/// of the pane is drawn anew when it slides, the less often it should.
constexpr int roomy(int length) {
    return length + length / 16 + 2 * margin;
}

constexpr int on_grid(int length) {
    return (length + grid - 1) / grid * grid;
}

/// An area of this length that holds the box, within limits. The room is above it where `way` is
/// positive, below it where that is negative, else on both sides.
Span placed(int length, Span box, int way, Span limits) {
    const int room = length - box.length;
    const int behind = std::min(margin, room);
    const int before = way == 0 ? room / 2 : way > 0 ? behind : room - behind;
    return {std::clamp(box.low - before, limits.low, limits.high() - length), length};
}

/// The area after the box has left it: it slides, or grows if the box is too long for that.
Span followed(Span area, Span box, Span first, Span monitor) {
    if (area.contains(box)) {
        return area;
    }
    int length = area.length;
    if (roomy(box.length) > length) {
        const int growth = std::max(reach, 2 * (box.length - first.length));
        length = std::clamp(on_grid(box.length + margin + growth), length, monitor.length);
    }
    const int way = (box.high() > area.high() ? 1 : 0) - (box.low < area.low ? 1 : 0);
    return placed(length, box, way, monitor);
}

/// For sprites of this length on this monitor.
int fitting(int length, Span monitor) {
    return std::min(on_grid(roomy(length)), monitor.length);
}

/// Around the first box.
Span begun(Span box, Span monitor) {
    return placed(fitting(box.length, monitor), box, 0, monitor);
}

/// The part of the area that boxes up to the largest need, with room where the box is going, and as
/// much again as it has become longer.
Span shrunk(Span area, int largest, Span box, Span first, Span monitor) {
    const int longer = std::max(0, box.length - first.length);
    const int length = std::min(area.length, fitting(largest + longer, monitor));
    const int moved = 2 * (box.low - first.low) + box.length - first.length;
    return placed(length, box, moved, area);
}

}  // namespace

Rect fitted_area(const Rect& box, const Rect& limits) {
    return both_axes(begun, box, limits);
}

Rect followed_area(const Pane& pane) {
    return both_axes(followed, pane.area, pane.shows, pane.first, pane.monitor);
}

Rect shrunk_area(const Pane& pane) {
    const Rect smaller =
        both_axes(shrunk, pane.area, pane.largest, pane.shows, pane.first, pane.monitor);
    return smaller.area() * 4 <= pane.area.area() * 3 ? smaller : pane.area;
}

}  // namespace hyrax
