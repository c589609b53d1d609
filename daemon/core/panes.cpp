// SPDX-License-Identifier: MIT
#include "daemon/core/panes.h"

#include "daemon/core/clusters.h"
#include "daemon/core/pane_shape.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace hyrax {

namespace {

constexpr Ticks shrink_after = ticks_per_second / 2;
/// Of a pane that has no window yet.
constexpr std::size_t no_slot = std::numeric_limits<std::size_t>::max();

Size size_of(const Rect& rect) {
    return {rect.width, rect.height};
}

void widen(Size& size, const Rect& box) {
    size.width = std::max(size.width, box.width);
    size.height = std::max(size.height, box.height);
}

bool meet(const Rect& a, const Rect& b) {
    return !intersection(a, b).empty();
}

/// The panes of one monitor, in the making.
class MonitorPlan {
public:
    MonitorPlan(const PaneScene& scene, const Rect& monitor, Ticks now);

    std::vector<Pane> continued(std::span<const Pane> before);

private:
    Pane begun(const Rect& shows, std::size_t slot = no_slot) const;
    std::vector<Rect> groups_of(std::span<const Rect> boxes) const;
    bool belong_together(const Rect& a, const Rect& b) const;
    void assign_sprites();
    void follow_sprites();
    bool divide(std::size_t index);
    bool join_a_pair();
    void join(std::size_t first, std::size_t second);

    const Rect& monitor_;
    bool drawable_;
    long long window_px_;
    Ticks now_;
    std::vector<Rect> boxes_;  ///< What is seen of the sprites.
    std::vector<Pane> panes_;
};

MonitorPlan::MonitorPlan(const PaneScene& scene, const Rect& monitor, Ticks now)
    : monitor_(monitor), drawable_(scene.drawable), window_px_(scene.window_px), now_(now) {
    boxes_.reserve(scene.sprites.size());
    for (const Rect& sprite : scene.sprites) {
        if (const Rect seen = intersection(sprite, monitor); !seen.empty()) {
            boxes_.push_back(seen);
        }
    }
}

std::vector<Pane> MonitorPlan::continued(std::span<const Pane> before) {
    std::ranges::copy_if(before, std::back_inserter(panes_), [this](const Pane& pane) {
        return pane.monitor == monitor_;
    });
    assign_sprites();
    follow_sprites();
    while (join_a_pair()) {}
    return std::move(panes_);
}

Pane MonitorPlan::begun(const Rect& shows, std::size_t slot) const {
    return {
        .slot = slot,
        .monitor = monitor_,
        .area = fitted_area(shows, monitor_),
        .shows = shows,
        .since = now_,
        .first = shows,
        .largest = size_of(shows),
    };
}

/// Windows of their own would meet, or cost more than one around both.
bool MonitorPlan::belong_together(const Rect& a, const Rect& b) const {
    const Rect one = fitted_area(a, monitor_);
    const Rect two = fitted_area(b, monitor_);
    return meet(one, two) ||
           fitted_area(united(a, b), monitor_).area() <= one.area() + two.area() + window_px_;
}

std::vector<Rect> MonitorPlan::groups_of(std::span<const Rect> boxes) const {
    return clusters_of(boxes, most_panes, [this](const Rect& a, const Rect& b) {
        return belong_together(a, b);
    });
}

/// Sprites stay with the pane they are in, others begin a new one. One that is in two belongs to
/// the first, which then meets the other.
void MonitorPlan::assign_sprites() {
    for (Pane& pane : panes_) {
        pane.shows = {};
    }
    std::vector<Rect> strays;
    for (const Rect& box : boxes_) {
        const auto home =
            std::ranges::find_if(panes_, [&](const Pane& pane) { return meet(pane.area, box); });
        if (home != panes_.end()) {
            home->shows = united(home->shows, box);
        } else {
            strays.push_back(box);
        }
    }
    std::erase_if(panes_, [](const Pane& pane) { return pane.shows.empty(); });
    for (const Rect& group : groups_of(strays)) {
        panes_.push_back(begun(group));
    }
}

void MonitorPlan::follow_sprites() {
    const std::size_t known = panes_.size();
    for (std::size_t i = 0; i < known; ++i) {
        Pane& pane = panes_[i];
        widen(pane.largest, pane.shows);
        const bool left = !pane.area.contains(pane.shows);
        if (!left && now_ - pane.since < shrink_after) {
            continue;
        }
        if (drawable_ && divide(i)) {
            continue;
        }
        pane.area = left ? followed_area(pane) : shrunk_area(pane);
        if (!left) {
            pane.since = now_;
            pane.first = pane.shows;
            pane.largest = size_of(pane.shows);
        }
    }
}

/// Replaces the pane by several if they cost a quarter less than one that fits.
bool MonitorPlan::divide(std::size_t index) {
    const Pane whole = panes_[index];
    std::vector<Rect> inside;
    std::ranges::copy_if(boxes_, std::back_inserter(inside), [&](const Rect& box) {
        return whole.shows.contains(box);
    });
    const std::vector<Rect> groups = groups_of(inside);
    if (groups.size() < 2) {
        return false;
    }
    std::vector<Pane> parts;
    long long cost = -window_px_;
    for (const Rect& group : groups) {
        parts.push_back(begun(group));
        cost += parts.back().area.area() + window_px_;
    }
    if (cost * 4 > fitted_area(whole.shows, monitor_).area() * 3) {
        return false;
    }
    const auto heir = std::ranges::max_element(parts, {}, [&](const Pane& part) {
        return intersection(part.area, whole.area).area();
    });
    heir->slot = whole.slot;
    panes_[index] = *heir;
    parts.erase(heir);
    panes_.insert(panes_.end(), parts.begin(), parts.end());
    return true;
}

/// Two panes that meet or belong together, or the cheapest pair of too many.
bool MonitorPlan::join_a_pair() {
    std::pair<std::size_t, std::size_t> cheapest;
    long long least = std::numeric_limits<long long>::max();
    for (std::size_t i = 0; i < panes_.size(); ++i) {
        for (std::size_t k = i + 1; k < panes_.size(); ++k) {
            const Pane& a = panes_[i];
            const Pane& b = panes_[k];
            if (meet(a.area, b.area) || belong_together(a.shows, b.shows)) {
                join(i, k);
                return true;
            }
            if (const long long extra = waste(a.area, b.area); extra < least) {
                least = extra;
                cheapest = {i, k};
            }
        }
    }
    if (panes_.size() <= most_panes) {
        return false;
    }
    join(cheapest.first, cheapest.second);
    return true;
}

/// The larger one goes on, in its area if that is enough.
void MonitorPlan::join(std::size_t first, std::size_t second) {
    Pane larger = panes_[first];
    Pane other = panes_[second];
    panes_.erase(panes_.begin() + static_cast<std::ptrdiff_t>(second));
    if (other.area.area() > larger.area.area()) {
        std::swap(larger, other);
    }
    const std::size_t slot = larger.slot != no_slot ? larger.slot : other.slot;
    const Rect shows = united(larger.shows, other.shows);
    if (larger.area.contains(shows)) {
        larger.slot = slot;
        larger.shows = shows;
        widen(larger.largest, shows);
        panes_[first] = larger;
    } else {
        panes_[first] = begun(shows, slot);
    }
}

/// Those of a monitor that is no more go on in the one that they lie in: it may have become wider.
std::vector<Pane> at_home(std::span<const Pane> panes, std::span<const Monitor> monitors) {
    std::vector<Pane> result(panes.begin(), panes.end());
    for (Pane& pane : result) {
        if (std::ranges::find(monitors, pane.monitor, &Monitor::bounds) != monitors.end()) {
            continue;
        }
        const auto home = std::ranges::find_if(monitors, [&](const Monitor& monitor) {
            return monitor.bounds.contains(pane.area);
        });
        if (home != monitors.end()) {
            pane.monitor = home->bounds;
        }
    }
    return result;
}

/// Each without one gets the lowest that none has, nor had before: its window still shows a pet.
void give_slots(std::vector<Pane>& panes, std::span<const Pane> before) {
    for (Pane& pane : panes) {
        if (pane.slot != no_slot) {
            continue;
        }
        std::size_t slot = 0;
        while (std::ranges::find(panes, slot, &Pane::slot) != panes.end() ||
               std::ranges::find(before, slot, &Pane::slot) != before.end()) {
            ++slot;
        }
        pane.slot = slot;
    }
}

/// The pane leaves a place that the other comes to.
bool gives_way(const Pane& pane, const Pane& other, std::span<const Pane> before) {
    const auto former = std::ranges::find(before, pane.slot, &Pane::slot);
    return former != before.end() && pane.slot != other.slot && meet(former->area, other.area);
}

}  // namespace

std::vector<Pane> plan_panes(const PaneScene& scene, std::span<const Pane> before, Ticks now) {
    const std::vector<Pane> known = at_home(before, scene.monitors);
    std::vector<Pane> panes;
    for (const Monitor& monitor : scene.monitors) {
        const Rect& bounds = monitor.bounds;
        // Mirrored monitors have the same bounds.
        if (std::ranges::find(scene.kept_free, bounds) == scene.kept_free.end() &&
            std::ranges::find(panes, bounds, &Pane::monitor) == panes.end()) {
            std::ranges::move(
                MonitorPlan(scene, bounds, now).continued(known), std::back_inserter(panes)
            );
        }
    }
    give_slots(panes, before);
    return panes;
}

/// Two that change places have no such order, and keep theirs.
void sort_for_showing(std::vector<Pane>& panes, std::span<const Pane> before) {
    for (auto first = panes.begin(); first != panes.end(); ++first) {
        const auto next = std::find_if(first, panes.end(), [&](const Pane& pane) {
            return std::none_of(first, panes.end(), [&](const Pane& other) {
                return gives_way(pane, other, before);
            });
        });
        if (next != panes.end()) {
            std::rotate(first, next, next + 1);
        }
    }
}

Ticks next_plan(std::span<const Pane> panes) {
    Ticks next = never;
    for (Pane pane : panes) {
        pane.first = pane.shows;
        pane.largest = size_of(pane.shows);
        if (shrunk_area(pane) != pane.area) {
            next = std::min(next, pane.since + shrink_after);
        }
    }
    return next;
}

}  // namespace hyrax
