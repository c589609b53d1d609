// SPDX-License-Identifier: MIT
#include "daemon/core/panes.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace hyrax {

namespace {

/// Lengths of panes are multiples of this [px], or the monitor's.
constexpr int grid = 64;
/// Free pixels around the sprites [px]: a pane is not changed for the first steps of a walk.
constexpr int margin = 32;
/// Room that growth adds at least [px], for a second of a run apart.
constexpr int reach = 384;
constexpr Ticks shrink_after = ticks_per_second;

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

Size size_of(const Rect& rect) {
    return {rect.width, rect.height};
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

/// The area, smaller where a quarter of it can be gained: the new surface and its full redraw are
/// paid with that.
Rect shrunk_if_worth_it(const Pane& pane) {
    const Rect smaller =
        both_axes(shrunk, pane.area, pane.largest, pane.shows, pane.first, pane.monitor);
    return smaller.area() * 4 <= pane.area.area() * 3 ? smaller : pane.area;
}

Pane continued(Pane pane, const Rect& shows, Ticks now) {
    pane.shows = shows;
    pane.largest.width = std::max(pane.largest.width, shows.width);
    pane.largest.height = std::max(pane.largest.height, shows.height);
    if (!pane.area.contains(shows)) {
        pane.area = both_axes(followed, pane.area, shows, pane.first, pane.monitor);
    } else if (now - pane.since >= shrink_after) {
        pane.area = shrunk_if_worth_it(pane);
        pane.first = shows;
        pane.largest = size_of(shows);
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
                .area = both_axes(begun, shows, monitor.bounds),
                .shows = shows,
                .since = now,
                .first = shows,
                .largest = size_of(shows),
            });
        }
    }
    return panes;
}

Ticks next_plan(std::span<const Pane> panes) {
    Ticks next = never;
    for (Pane pane : panes) {
        pane.first = pane.shows;
        pane.largest = size_of(pane.shows);
        if (shrunk_if_worth_it(pane) != pane.area) {
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
