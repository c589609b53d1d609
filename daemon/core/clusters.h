// SPDX-License-Identifier: MIT
// Covers many rectangles with few: joins those that belong together by whatever rule.
#pragma once

#include "physics/geometry.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace hyrax {

/// How many more pixels one rectangle around both has than the two of them; negative where they
/// overlap much.
constexpr long long waste(const Rect& a, const Rect& b) {
    return united(a, b).area() - a.area() - b.area();
}

/// Joins the rectangle with a cluster it belongs to by `belong(cluster, rectangle)`, and the result
/// with the next one, until it stands alone.
void add_to_clusters(std::vector<Rect>& clusters, Rect rect, const auto& belong) {
    for (std::size_t i = 0; i < clusters.size();) {
        if (belong(clusters[i], rect)) {
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

/// Of at least two: joins those that waste least, and whatever belongs to the result.
void join_cheapest_pair(std::vector<Rect>& clusters, const auto& belong) {
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
    add_to_clusters(clusters, joined, belong);
}

/// At most `most` clusters (> 0) that hold all of the rectangles.
std::vector<Rect> clusters_of(const auto& rects, std::size_t most, const auto& belong) {
    std::vector<Rect> clusters;
    for (const Rect& rect : rects) {
        add_to_clusters(clusters, rect, belong);
        while (clusters.size() > most) {
            join_cheapest_pair(clusters, belong);
        }
    }
    return clusters;
}

}  // namespace hyrax
