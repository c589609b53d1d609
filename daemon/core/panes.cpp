// SPDX-License-Identifier: MIT
#include "daemon/core/panes.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace hyrax {

namespace {

/// Panes begin and end on multiples of this [px], so that small moves change nothing.
constexpr int grid = 128;
/// Free pixels around the sprites [px]: a pane is not changed for the first steps of a walk.
constexpr int margin = 32;
/// Room that growth adds ahead at least [px], for a second of a run.
constexpr int reach = 384;
constexpr Ticks shrink_after = ticks_per_second;

constexpr int snapped_down(int value) {
    const int rest = value % grid;
    return rest < 0 ? value - rest - grid : value - rest;
}

constexpr int snapped_up(int value) {
    return -snapped_down(-value);
}

/// The grid's cells that hold the box and its margin, as far as the monitor shows them.
Rect roomy(const Rect& box, const Rect& monitor) {
    const int x = snapped_down(box.x - margin);
    const int y = snapped_down(box.y - margin);
    const Rect cells{
        x, y, snapped_up(box.right() + margin) - x, snapped_up(box.bottom() + margin) - y
    };
    return intersection(cells, monitor);
}

/// How far to go beyond an edge that was crossed after it had moved so far outward in this span.
int ahead_of(bool crossed, int moved) {
    return crossed ? std::max(reach, 2 * moved) : 0;
}

/// The area, enlarged to hold what the pane shows, and further still where that has crossed it.
Rect grown(const Pane& pane) {
    const Rect& area = pane.area;
    const Rect& box = pane.shows;
    const Rect& from = pane.first;
    const int left = ahead_of(box.x < area.x, from.x - box.x);
    const int top = ahead_of(box.y < area.y, from.y - box.y);
    const int right = ahead_of(box.right() > area.right(), box.right() - from.right());
    const int bottom = ahead_of(box.bottom() > area.bottom(), box.bottom() - from.bottom());
    const Rect ahead{
        box.x - left, box.y - top, box.width + left + right, box.height + top + bottom
    };
    return united(area, roomy(ahead, pane.monitor));
}

/// A quarter must be gained: the new surface and its full redraw are paid with it.
bool worth_shrinking(const Rect& area, const Rect& to) {
    return to.area() * 4 <= area.area() * 3;
}

/// What the next span will need if every edge goes on as it went in this one: without it, a pane
/// that has just shrunk around a running pet would have to grow at once.
Rect expected(const Pane& pane) {
    const Rect& now = pane.shows;
    const int left = std::min(0, now.x - pane.first.x);
    const int top = std::min(0, now.y - pane.first.y);
    const int right = std::max(0, now.right() - pane.first.right());
    const int bottom = std::max(0, now.bottom() - pane.first.bottom());
    const Rect ahead{
        now.x + left, now.y + top, now.width + right - left, now.height + bottom - top
    };
    return united(pane.needed, ahead);
}

Pane continued(Pane pane, const Rect& shows, Ticks now) {
    pane.shows = shows;
    pane.needed = united(pane.needed, shows);
    if (!pane.area.contains(shows)) {
        pane.area = grown(pane);
    } else if (now - pane.since >= shrink_after) {
        const Rect smaller = roomy(expected(pane), pane.monitor);
        if (worth_shrinking(pane.area, smaller)) {
            pane.area = smaller;
        }
        pane.first = shows;
        pane.needed = shows;
        pane.since = now;
    }
    return pane;
}

Rect seen_on(const Rect& monitor, std::span<const Rect> sprites) {
    Rect box;
    for (const Rect& sprite : sprites) {
        box = united(box, intersection(sprite, monitor));
    }
    return box;
}

/// How many more pixels one rectangle around both has than the two of them.
long long waste(const Rect& a, const Rect& b) {
    return united(a, b).area() - a.area() - b.area();
}

/// The spare pixels cost less than a further call, or are at most 0.3 of the two.
bool belong_together(const Rect& a, const Rect& b, long long call_px) {
    return waste(a, b) <= std::max(call_px, (a.area() + b.area()) * 3 / 10);
}

/// Joins the rectangle with a cluster it belongs to, and the result with the next one, until it
/// stands alone.
void add_to(std::vector<Rect>& clusters, Rect rect, long long call_px) {
    for (std::size_t i = 0; i < clusters.size();) {
        if (belong_together(clusters[i], rect, call_px)) {
            rect = united(clusters[i], rect);
            clusters[i] = clusters.back();
            clusters.pop_back();
            i = 0;
        } else {
            ++i;
        }
    }
    clusters.push_back(rect);
}

void join_cheapest_pair(std::vector<Rect>& clusters, long long call_px) {
    std::size_t first = 0;
    std::size_t second = 1;
    long long least = std::numeric_limits<long long>::max();
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        for (std::size_t k = i + 1; k < clusters.size(); ++k) {
            const long long extra = waste(clusters[i], clusters[k]);
            if (extra < least) {
                least = extra;
                first = i;
                second = k;
            }
        }
    }
    const Rect joined = united(clusters[first], clusters[second]);
    clusters[second] = clusters.back();
    clusters.pop_back();
    clusters[first] = clusters.back();
    clusters.pop_back();
    add_to(clusters, joined, call_px);
}

std::uint64_t key_of(PetId id) {
    return (std::uint64_t{id.generation} << 32U) | id.index;
}

/// Both frames show the same pets in the same order.
bool same_cast(const Frame& a, const Frame& b) {
    return std::ranges::equal(a.sprites, b.sprites, {}, &Sprite::pet, &Sprite::pet);
}

/// For pets that came, went or changed their order: a pet that stands before others than it did
/// counts as changed, too.
std::vector<Rect> changed_cast(const Frame& before, const Frame& after) {
    std::unordered_map<std::uint64_t, std::size_t> places_before;
    for (std::size_t i = 0; i < before.sprites.size(); ++i) {
        places_before.emplace(key_of(before.sprites[i].pet), i);
    }
    std::vector<Rect> places;
    std::vector<bool> unchanged(before.sprites.size(), false);
    std::size_t in_order_from = 0;
    for (const Sprite& sprite : after.sprites) {
        const auto found = places_before.find(key_of(sprite.pet));
        if (found != places_before.end() && found->second >= in_order_from &&
            before.sprites[found->second] == sprite) {
            in_order_from = found->second + 1;
            unchanged[found->second] = true;
        } else {
            places.push_back(sprite.bounds());
        }
    }
    for (std::size_t i = 0; i < before.sprites.size(); ++i) {
        if (!unchanged[i]) {
            places.push_back(before.sprites[i].bounds());
        }
    }
    return places;
}

}  // namespace

std::vector<Pane> plan_panes(
    std::span<const Monitor> monitors,
    std::span<const Rect> sprites,
    std::span<const Pane> before,
    Ticks now,
    std::span<const Rect> kept_free
) {
    std::vector<Pane> panes;
    for (const Monitor& monitor : monitors) {
        if (std::ranges::find(kept_free, monitor.bounds) != kept_free.end()) {
            continue;
        }
        const Rect shows = seen_on(monitor.bounds, sprites);
        if (shows.empty()) {
            continue;
        }
        const auto known = std::ranges::find(before, monitor.bounds, &Pane::monitor);
        if (known != before.end()) {
            panes.push_back(continued(*known, shows, now));
        } else if (std::ranges::find(panes, monitor.bounds, &Pane::monitor) == panes.end()) {
            panes.push_back({
                .monitor = monitor.bounds,
                .area = roomy(shows, monitor.bounds),
                .shows = shows,
                .since = now,
                .first = shows,
                .needed = shows,
            });
        }
    }
    return panes;
}

Ticks next_plan(std::span<const Pane> panes) {
    Ticks next = never;
    for (const Pane& pane : panes) {
        if (worth_shrinking(pane.area, roomy(pane.shows, pane.monitor))) {
            next = std::min(next, pane.since + shrink_after);
        }
    }
    return next;
}

std::vector<Rect> places_of(const Frame& frame) {
    std::vector<Rect> places;
    places.reserve(frame.sprites.size());
    for (const Sprite& sprite : frame.sprites) {
        places.push_back(sprite.bounds());
    }
    return places;
}

std::vector<Rect> changed_places(const Frame& before, const Frame& after) {
    if (!same_cast(before, after)) {
        return changed_cast(before, after);
    }
    std::vector<Rect> places;
    for (std::size_t i = 0; i < after.sprites.size(); ++i) {
        if (before.sprites[i] != after.sprites[i]) {
            places.push_back(before.sprites[i].bounds());
            places.push_back(after.sprites[i].bounds());
        }
    }
    return places;
}

std::vector<Rect> dirty_clusters(
    std::span<const Rect> places, const Rect& area, const PresentCost& cost
) {
    std::vector<Rect> clusters;
    for (const Rect& place : places) {
        const Rect seen = intersection(place, area);
        if (seen.empty()) {
            continue;
        }
        add_to(clusters, seen, cost.call_px);
        while (clusters.size() > std::max<std::size_t>(cost.most_calls, 1)) {
            join_cheapest_pair(clusters, cost.call_px);
        }
    }
    for (const Rect& cluster : clusters) {
        if (cluster.area() * 100 >= area.area() * cost.whole_percent) {
            return {area};
        }
    }
    return clusters;
}

}  // namespace hyrax
