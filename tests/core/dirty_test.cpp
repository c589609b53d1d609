// SPDX-License-Identifier: MIT
#include "daemon/core/dirty.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace hyrax;

namespace {

constexpr Rect main_screen{0, 0, 1920, 1080};

Rect pet_at_place(int x, int y) {
    return {x, y, 96, 96};
}

Sprite sprite(std::uint32_t index, int x, int y) {
    static const Image image(Size{96, 96});
    return {image, {x, y}, {index, 1}};
}

bool covered(const std::vector<Rect>& clusters, const Rect& place) {
    for (int y = place.y; y < place.bottom(); y += 8) {
        for (int x = place.x; x < place.right(); x += 8) {
            const auto holds = [&](const Rect& cluster) { return cluster.contains(Point{x, y}); };
            if (std::ranges::none_of(clusters, holds)) {
                return false;
            }
        }
    }
    return true;
}

long long area_of(const std::vector<Rect>& rects) {
    long long sum = 0;
    for (const Rect& rect : rects) {
        sum += rect.area();
    }
    return sum;
}

}  // namespace

TEST_CASE("equal frames have no changed places") {
    const Frame frame{{sprite(1, 10, 10), sprite(2, 500, 10)}};
    CHECK(changed_places(frame, frame).empty());
}

TEST_CASE("a moved sprite changes its old and its new place") {
    const Frame before{{sprite(1, 10, 10), sprite(2, 500, 10)}};
    const Frame after{{sprite(1, 10, 10), sprite(2, 520, 10)}};
    CHECK(changed_places(before, after) == std::vector<Rect>{{500, 10, 96, 96}, {520, 10, 96, 96}});
}

TEST_CASE("sprites that come, go or change their order are changed places") {
    const Frame one{{sprite(1, 10, 10)}};
    const Frame two{{sprite(2, 500, 10), sprite(1, 10, 10)}};
    CHECK(changed_places(one, two) == std::vector<Rect>{{500, 10, 96, 96}});
    CHECK(changed_places(two, one) == std::vector<Rect>{{500, 10, 96, 96}});
    CHECK(changed_places({}, one) == std::vector<Rect>{{10, 10, 96, 96}});

    const Frame swapped{{sprite(1, 10, 10), sprite(2, 500, 10)}};
    const std::vector<Rect> places = changed_places(two, swapped);
    CHECK(std::ranges::find(places, Rect{500, 10, 96, 96}) != places.end());
}

TEST_CASE("near places become one cluster, distant ones stay apart") {
    const std::vector<Rect> near{{500, 10, 96, 96}, {512, 10, 96, 96}};
    CHECK(dirty_clusters(near, main_screen, {}) == std::vector<Rect>{{500, 10, 108, 96}});

    const Rect wide{-5000, 0, 12000, 1080};
    const std::vector<Rect> distant{pet_at_place(-5000, 0), pet_at_place(5000, 0)};
    const std::vector<Rect> clusters = dirty_clusters(distant, wide, {});
    CHECK(clusters.size() == 2);
    CHECK(area_of(clusters) == area_of(distant));
    // Where a call costs as much as copying the whole window, there is one.
    CHECK(dirty_clusters(distant, wide, {.call_px = wide.area()}).size() == 1);
}

TEST_CASE("clusters are clipped to the pane, and there are few of them") {
    CHECK(
        dirty_clusters(std::vector{pet_at_place(-40, 0)}, main_screen, {}) ==
        std::vector<Rect>{{0, 0, 56, 96}}
    );
    CHECK(dirty_clusters(std::vector{pet_at_place(-400, 0)}, main_screen, {}).empty());

    std::mt19937 random(11);
    std::uniform_int_distribution<int> x(-50, 1900);
    std::uniform_int_distribution<int> y(-50, 1060);
    std::vector<Rect> places;
    for (int i = 0; i < 60; ++i) {
        places.push_back(pet_at_place(x(random), y(random)));
        for (const std::size_t most : {std::size_t{1}, std::size_t{4}, std::size_t{8}}) {
            const std::vector<Rect> clusters =
                dirty_clusters(places, main_screen, {.most_calls = most});
            CHECK(clusters.size() <= most);
            for (const Rect& place : places) {
                CHECK(covered(clusters, intersection(place, main_screen)));
            }
        }
    }
}

TEST_CASE("a cluster that holds most of the area becomes the area, if that is cheaper") {
    const Rect area{0, 0, 1000, 1000};
    const std::vector<Rect> most{{0, 0, 1000, 800}};
    CHECK(dirty_clusters(most, area, {.whole_percent = 75}) == std::vector{area});
    CHECK(dirty_clusters(most, area, {.whole_percent = 81}) == most);
    CHECK(dirty_clusters(most, area, {}) == most);
}
