// SPDX-License-Identifier: MIT
#include "daemon/core/ledges.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace hyrax {
namespace {

struct Interval {
    int low = 0;
    int high = 0;
};

bool counts(const DesktopWindow& window) {
    return window.visible && window.solid && !window.bounds.empty();
}

bool gives_ledge(
    const DesktopWindow& window, const std::vector<Monitor>& monitors, LedgeMode mode
) {
    const bool fills_monitor = std::ranges::any_of(monitors, [&window](const Monitor& monitor) {
        return window.bounds.contains(monitor.bounds);
    });
    return counts(window) && window.has_caption && !window.maximised && !fills_monitor &&
           window.bounds.width >= least_ledge_window.width &&
           window.bounds.height >= least_ledge_window.height &&
           (mode == LedgeMode::all || window.active);
}

// The top edge within the work areas; parts that touch are one.
std::vector<Interval> on_screen(const Rect& bounds, const std::vector<Monitor>& monitors) {
    std::vector<Interval> parts;
    for (const Monitor& monitor : monitors) {
        const Rect& area = monitor.work.empty() ? monitor.bounds : monitor.work;
        const Interval part{std::max(bounds.x, area.x), std::min(bounds.right(), area.right())};
        if (bounds.y >= area.y && bounds.y < area.bottom() && part.low < part.high) {
            parts.push_back(part);
        }
    }
    std::ranges::sort(parts, {}, &Interval::low);
    std::vector<Interval> joined;
    for (const Interval& part : parts) {
        if (!joined.empty() && part.low <= joined.back().high) {
            joined.back().high = std::max(joined.back().high, part.high);
        } else {
            joined.push_back(part);
        }
    }
    return joined;
}

void cut_out(std::vector<Interval>& parts, Interval hole) {
    std::vector<Interval> rest;
    for (const Interval& part : parts) {
        const Interval before{part.low, std::min(part.high, hole.low)};
        const Interval after{std::max(part.low, hole.high), part.high};
        for (const Interval& piece : {before, after}) {
            if (piece.low < piece.high) {
                rest.push_back(piece);
            }
        }
    }
    parts = std::move(rest);
}

}  // namespace

std::vector<LedgeSegment> ledges_of(
    std::span<const DesktopWindow> windows, const std::vector<Monitor>& monitors, LedgeMode mode
) {
    std::vector<LedgeSegment> segments;
    if (mode == LedgeMode::off) {
        return segments;
    }
    int count = 0;
    for (std::size_t i = 0; i < windows.size() && count < most_ledge_windows; ++i) {
        const Rect& bounds = windows[i].bounds;
        if (!gives_ledge(windows[i], monitors, mode)) {
            continue;
        }
        ++count;
        std::vector<Interval> parts = on_screen(bounds, monitors);
        for (const DesktopWindow& above : windows.first(i)) {
            const Rect& cover = above.bounds;
            if (counts(above) && cover.y <= bounds.y && cover.bottom() > bounds.y) {
                cut_out(parts, {cover.x, cover.right()});
            }
        }
        for (const Interval& part : parts) {
            segments.push_back({{part.low, part.high, bounds.y}, windows[i].id, bounds});
        }
    }
    return segments;
}

}  // namespace hyrax
