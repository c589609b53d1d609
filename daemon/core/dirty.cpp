// SPDX-License-Identifier: MIT
#include "daemon/core/dirty.h"

#include "daemon/core/clusters.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <unordered_map>

namespace hyrax {

namespace {

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

std::vector<Rect> places_of(const Frame& frame) {
    std::vector<Rect> places;
    places.reserve(frame.sprites.size());
    for (const Sprite& sprite : frame.sprites) {
        places.push_back(sprite.bounds());
    }
    return places;
}

std::vector<Rect> changed_places(const Frame& before, const Frame& after) {
    if (before.edition != after.edition) {
        std::vector<Rect> all = places_of(before);
        std::ranges::copy(places_of(after), std::back_inserter(all));
        return all;
    }
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
    std::vector<Rect> seen;
    seen.reserve(places.size());
    for (const Rect& place : places) {
        if (const Rect part = intersection(place, area); !part.empty()) {
            seen.push_back(part);
        }
    }
    // The spare pixels cost less than a further call, or are at most 0.3 of the two.
    const auto belong_together = [&](const Rect& a, const Rect& b) {
        return waste(a, b) <= std::max(cost.call_px, (a.area() + b.area()) * 3 / 10);
    };
    std::vector<Rect> clusters =
        clusters_of(seen, std::max<std::size_t>(cost.most_calls, 1), belong_together);
    for (const Rect& cluster : clusters) {
        if (cluster.area() * 100 >= area.area() * cost.whole_percent) {
            return {area};
        }
    }
    return clusters;
}

}  // namespace hyrax
