// SPDX-License-Identifier: MIT
#include "daemon/core/hand.h"

#include <doctest/doctest.h>

using namespace hyrax;

namespace {

constexpr Ticks ms = ticks_per_ms;
constexpr PetId pet{3, 1};

}  // namespace

TEST_CASE("a hand carries what it took by the place it took it at") {
    Hand hand;
    CHECK_FALSE(hand.pet());
    hand.take(pet, {-10.0, -20.0}, {100, 200}, 0);
    CHECK(hand.pet() == pet);
    CHECK(hand.carried_to() == Vec2{90.0, 180.0});
    CHECK(hand.move({-1500, -150}));
    CHECK_FALSE(hand.move({-1500, -150}));
    CHECK(hand.carried_to() == Vec2{-1510.0, -170.0});
    hand.drop();
    CHECK_FALSE(hand.pet());
}

TEST_CASE("a click is short and stays in place") {
    Hand hand;
    hand.take(pet, {}, {100, 100}, 0);
    CHECK(hand.move({103, 98}));
    CHECK(hand.was_click(100 * ms));
    CHECK_FALSE(hand.was_click(500 * ms));
    CHECK(hand.move({120, 98}));
    CHECK(hand.move({100, 100}));
    CHECK_FALSE(hand.was_click(100 * ms));
}
