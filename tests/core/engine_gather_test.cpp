// SPDX-License-Identifier: MIT
// Calling all pets to one place.
#include "tests/core/engine_world.h"

#include <random>

using namespace hyrax;

namespace {

constexpr Rect left{-1600, -200, 1600, 900};
constexpr Rect right{0, 0, 1920, 1080};

bool is_inside(const Rect& place, const Pet& pet) {
    const Vec2 at = pet.position();
    return at.x >= place.x && at.y >= place.y && at.x + box.width <= place.right() &&
           at.y + box.height <= place.bottom();
}

}  // namespace

TEST_CASE("gather: from everywhere to a row along the top, and then all fall in") {
    World world;
    world.engine.set_arena(Arena({monitor(right), monitor(left)}, FloorEdge::work_area));
    std::minstd_rand random(5);
    std::vector<PetId> ids;
    for (int i = 0; i < 20; ++i) {
        const auto number = [&random](int below) { return static_cast<double>(random() % below); };
        ids.push_back(world.spawn({number(3000) - 1600, number(800)}, {number(900) - 450, 0.0}));
    }
    world.run(2.0);
    world.engine.gather(left);
    CHECK(world.engine.size() == 20);
    std::vector<double> places;
    for (const PetId id : ids) {
        CHECK(is_inside(left, world.pet(id)));
        CHECK(world.pet(id).velocity() == Vec2{});
        CHECK(world.pet(id).awake);
        if (world.pet(id).position().y == left.y) {
            places.push_back(world.pet(id).position().x);
        }
    }
    CHECK(places.size() == 16);  // as many as stand side by side
    for (std::size_t i = 1; i < places.size(); ++i) {
        CHECK(places[i] >= places[i - 1] + box.width);
    }
    world.run(10.0);
    CHECK_FALSE(world.engine.moving());
    for (const PetId id : ids) {
        CHECK(is_inside(left, world.pet(id)));
        CHECK(world.pet(id).position().y == left.bottom() - box.height);
    }
}

TEST_CASE("gather: more pets than a place has room for stay inside all the same") {
    World world;
    for (int i = 0; i < 100; ++i) {
        world.spawn({500.0, 500.0});
    }
    constexpr Rect small{100, 100, 250, 200};
    world.engine.gather(small);
    world.engine.for_each([&](PetId, const Pet& pet) { CHECK(is_inside(small, pet)); });
}

TEST_CASE("gather: a place outside the arena, or smaller than a pet, is taken as near as can be") {
    for (const Rect& place : {Rect{5000, 5000, 10, 10}, Rect{0, 0, 0, 0}, Rect{-900, 30, 20, 20}}) {
        World world;
        const PetId id = world.spawn({300.0, 300.0}, {100.0, 0.0});
        world.engine.gather(place);
        CHECK(is_inside(right, world.pet(id)));
        world.run(5.0);
        CHECK_FALSE(world.engine.moving());
    }
}

TEST_CASE("gather: a pet in the hand stays there, and nobody is called to nowhere") {
    World world;
    const PetId held = world.spawn({300.0, 300.0});
    const PetId other = world.spawn({900.0, 300.0});
    REQUIRE(world.engine.grab(held, 0));
    world.engine.gather(right);
    CHECK(world.pet(held).motion == Motion::held);
    CHECK(world.pet(held).position() == Vec2{300.0, 300.0});
    CHECK(world.pet(other).position() == Vec2{(1920.0 - box.width) / 2.0, 0.0});

    World empty;
    empty.engine.gather(right);
    empty.spawn({1.0, 1.0});
    empty.engine.set_arena({});
    empty.engine.gather(right);
    CHECK(empty.engine.size() == 1);
}
