// SPDX-License-Identifier: MIT
#include "daemon/core/collisions.h"

#include "tests/core/engine_world.h"

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace hyrax;

namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

// Every pair looked at.
Pairs overlapping(const std::vector<CollisionBox>& boxes) {
    Pairs pairs;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
            if (overlap(boxes[i], boxes[j])) {
                pairs.emplace(boxes[i].pet.index, boxes[j].pet.index);
            }
        }
    }
    return pairs;
}

}  // namespace

TEST_CASE("the sweep finds what looking at every pair finds") {
    std::minstd_rand random(7);
    const auto number = [&random](int most) { return static_cast<int>(random() % most); };
    for (int round = 0; round < 60; ++round) {
        const std::size_t count = 1 + static_cast<std::size_t>(number(40));
        std::vector<CollisionBox> boxes(count);
        Collisions collisions;
        Pairs before;
        for (int step = 0; step < 25; ++step) {
            collisions.begin(count);
            for (std::uint32_t i = 0; i < count; ++i) {
                // Few places and sizes: many boxes share a side without overlapping.
                boxes[i] = {
                    {i, 1},
                    {number(12) * 20.0, number(12) * 20.0},
                    {20 * (1 + number(3)), 20 * (1 + number(3))},
                    {number(100) - 50.0, number(100) - 50.0},
                };
                collisions.add(boxes[i]);
            }
            const Pairs now = overlapping(boxes);
            Pairs expected;
            std::ranges::set_difference(now, before, std::inserter(expected, expected.end()));
            Pairs found;
            for (const Collision& met : collisions.find()) {
                CHECK(found.emplace(met.a.index, met.b.index).second);
                CHECK(met.speed == closing_speed(boxes[met.a.index], boxes[met.b.index]));
            }
            CHECK(found == (step == 0 ? Pairs{} : expected));
            before = now;
        }
    }
}

TEST_CASE("a pair counts by its ids: who takes the place of another has begun to touch") {
    Collisions collisions;
    const auto look = [&collisions](std::uint32_t generation) {
        collisions.begin(2);
        collisions.add({{0, 1}, {0, 0}, {10, 10}, {}});
        collisions.add({{1, generation}, {5, 5}, {10, 10}, {}});
        return collisions.find().size();
    };
    CHECK(look(1) == 0);
    CHECK(look(1) == 0);
    CHECK(look(2) == 1);
    CHECK(look(2) == 0);
    collisions.forget();
    CHECK(look(3) == 0);
}

TEST_CASE("the closing speed is that of the middles") {
    const CollisionBox still{{}, {0, 0}, {10, 10}, {}};
    CHECK(closing_speed(still, {{}, {8, 0}, {10, 10}, {-30, 400}}) == doctest::Approx(30));
    CHECK(closing_speed(still, {{}, {8, 0}, {10, 10}, {30, 0}}) == 0.0);
    CHECK(closing_speed(still, {{}, {0, 0}, {10, 10}, {3, 4}}) == doctest::Approx(5));
}

TEST_CASE("pets that meet are told once, to those who listen") {
    World world(EngineSettings{.physics = {.gravity = 0, .air_drag = 1}});
    const PetId a = world.spawn({0, 500}, {200, 0});
    const PetId b = world.spawn({600, 500}, {-100, 0});
    world.engine.take_events();
    std::vector<Event> met;
    for (int i = 0; i < 120; ++i) {
        world.engine.advance(i * frame);
        for (const Event& event : world.engine.take_events()) {
            if (event.kind == EventKind::collide) {
                met.push_back(event);
            }
        }
    }
    REQUIRE(met.size() == 1);
    CHECK(met[0].pet == a);
    CHECK(met[0].other == b);
    CHECK(met[0].speed == doctest::Approx(300));

    world.engine.listen({});
    for (int i = 120; i < 900; ++i) {
        world.engine.advance(i * frame);
    }
    CHECK_FALSE(world.engine.has_events());
}
