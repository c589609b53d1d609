// SPDX-License-Identifier: MIT
// Where a box may be, against brute force over the monitors.
#include "physics/free_space.h"

#include "tests/physics/layouts.h"
#include "tests/physics/random_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

using namespace hyrax;
using namespace hyrax::test;

namespace {

Vec2 near_the_rooms(Random& random, const std::vector<Rect>& rooms) {
    Rect bounds;
    for (const Rect& room : rooms) {
        bounds = united(bounds, room);
    }
    const Vec2 place{
        random.between(bounds.x - 300.0, bounds.right() + 100.0),
        random.between(bounds.y - 300.0, bounds.bottom() + 100.0)
    };
    // Whole numbers now and then: sides lie there.
    return random.one_in(2) ? place : Vec2{std::round(place.x), std::round(place.y)};
}

}  // namespace

TEST_CASE("a place is free exactly where the monitors cover the whole box") {
    int free = 0;
    for (const Layout& layout : layouts()) {
        CAPTURE(layout.name);
        const FreeSpace space = FreeSpace::among(layout.rooms, layout.box);
        const std::vector<Rect> rooms = all_rooms(layout);
        const Vec2 size{
            layout.box.width - 2.0 * space.overhang().x,
            layout.box.height - 2.0 * space.overhang().y
        };
        Random random(1);
        for (int i = 0; i < 5000; ++i) {
            const Vec2 place = near_the_rooms(random, rooms);
            CAPTURE(place.x);
            CAPTURE(place.y);
            const bool is_free = covered(rooms, place, size);
            free += is_free ? 1 : 0;
            CHECK(space.contains(place) == is_free);
        }
    }
    CHECK(free > 20'000);
}

TEST_CASE("the nearest place is free, and none is nearer") {
    for (const Layout& layout : layouts()) {
        CAPTURE(layout.name);
        const FreeSpace space = FreeSpace::among(layout.rooms, layout.box);
        Random random(2);
        for (int i = 0; i < 300; ++i) {
            const Vec2 from = near_the_rooms(random, layout.rooms);
            CAPTURE(from.x);
            CAPTURE(from.y);
            const Vec2 found = space.nearest(from);
            CHECK(space.contains(found));
            if (space.contains(from)) {
                CHECK(found == from);
                continue;
            }
            const double reach = distance(found, from);
            for (int angle = 0; angle < 60; ++angle) {
                const double share = 0.999 * random.between(0.0, 1.0);
                const Vec2 nearer{
                    from.x + reach * share * std::cos(angle * 0.104719755),
                    from.y + reach * share * std::sin(angle * 0.104719755)
                };
                CHECK(!space.contains(nearer));
            }
        }
    }
}

TEST_CASE("of two equally near places the upper, and none for what is nowhere") {
    const FreeSpace space(std::vector<Obstacle>{{0.0, 0.0, 100.0, 100.0}});
    CHECK(space.nearest({50.0, 50.0}) == Vec2{50.0, 0.0});
    CHECK(space.nearest({10.0, 90.0}) == Vec2{0.0, 90.0});
    CHECK(space.nearest({90.0, 90.0}).y == 90.0);
    CHECK(space.nearest({0.0, 50.0}) == Vec2{0.0, 50.0});
    CHECK(FreeSpace().nearest({3.0, -4.0}) == Vec2{3.0, -4.0});
    CHECK(FreeSpace::among({}, {10, 10}) == FreeSpace());
    CHECK(FreeSpace::among({{5, 5, 0, 100}}, {10, 10}) == FreeSpace());
}

TEST_CASE("one room is one box, and so are rooms that make one") {
    const FreeSpace one = FreeSpace::among({{0, 0, 3840, 1080}}, {100, 80});
    CHECK(one == FreeSpace::box(0.0, 0.0, 3740.0, 1000.0));
    CHECK(one.is_box());
    CHECK(FreeSpace::among({{0, 0, 1920, 1080}, {1920, 0, 1920, 1080}}, {100, 80}) == one);
    CHECK(FreeSpace::among({{0, 0, 1920, 1080}, {1921, 0, 1919, 1080}}, {100, 80}) == one);
    CHECK(FreeSpace::among({{0, 0, 3840, 540}, {0, 541, 3840, 539}}, {100, 80}) == one);
    CHECK(FreeSpace::among({{0, 0, 3840, 1080}, {10, 10, 50, 50}}, {100, 80}) == one);
    CHECK(!FreeSpace::among({{0, 0, 1920, 1080}, {1922, 0, 1918, 1080}}, {100, 80}).is_box());
}

TEST_CASE("the order of the monitors does not matter") {
    for (const Layout& layout : layouts()) {
        CAPTURE(layout.name);
        const FreeSpace space = FreeSpace::among(layout.rooms, layout.box);
        std::vector<Rect> turned(layout.rooms.rbegin(), layout.rooms.rend());
        const FreeSpace other = FreeSpace::among(turned, layout.box);
        CHECK(std::ranges::is_permutation(space.obstacles(), other.obstacles()));
    }
}

TEST_CASE("a floor goes on across solids of one height, and a slot as wide as the box") {
    // Two solids of one height that touch, one that overlaps, one apart, one higher.
    const FreeSpace space(std::vector<Obstacle>{
        {0.0, 100.0, 50.0, 200.0},
        {50.0, 100.0, 80.0, 200.0},
        {70.0, 100.0, 120.0, 300.0},
        {130.0, 100.0, 160.0, 200.0},
        {110.0, 90.0, 115.0, 95.0},
    });
    const std::optional<Support> floor = space.support({75.0, 100.0});
    REQUIRE(floor.has_value());
    CHECK(floor->left == 0.0);
    CHECK(floor->right == 120.0);
    CHECK(space.support({1.0, 100.0})->right == 120.0);
    CHECK(space.support({140.0, 100.0})->left == 130.0);
    CHECK(!space.support({0.0, 100.0}));
    CHECK(!space.support({50.0, 100.0}));
    CHECK(!space.support({125.0, 100.0}));
    CHECK(!space.support({60.0, 99.0}));
}

TEST_CASE("the walls of a place are those at its height") {
    const FreeSpace space(std::vector<Obstacle>{
        {.right = 0.0},
        {.left = 1000.0},
        {200.0, 100.0, 300.0, 200.0},
        {600.0, 150.0, 700.0, 250.0},
    });
    const auto walls = [&](double x, double y) { return space.corridor({x, y}); };
    CHECK(walls(450.0, 175.0).left == 300.0);
    CHECK(walls(450.0, 175.0).right == 600.0);
    CHECK(walls(300.0, 125.0).left == 300.0);
    CHECK(walls(450.0, 125.0).right == 1000.0);
    // The ends of a side are no part of it.
    CHECK(walls(450.0, 100.0).left == 0.0);
    CHECK(walls(450.0, 150.0).right == 1000.0);
    CHECK(walls(450.0, 250.0).right == 1000.0);
    CHECK(FreeSpace().corridor({0.0, 0.0}).left == -infinity);
}
