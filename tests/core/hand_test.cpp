// SPDX-License-Identifier: MIT
#include "daemon/core/hand.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace hyrax;

namespace {

constexpr Ticks ms = ticks_per_ms;
constexpr double no_limit = 1e9;
constexpr PetId pet{3, 1};

}  // namespace

TEST_CASE("a hand carries what it took by the place it took it at") {
    Hand hand;
    CHECK_FALSE(hand.pet());
    hand.take(pet, {-10.0, -20.0}, {100, 200}, 0);
    CHECK(hand.pet() == pet);
    CHECK(hand.carried_to() == Vec2{90.0, 180.0});
    hand.move({-1500, -150}, 10 * ms);
    CHECK(hand.carried_to() == Vec2{-1510.0, -170.0});
    hand.drop();
    CHECK_FALSE(hand.pet());
}

TEST_CASE("a steady hand throws with its own velocity") {
    Hand hand;
    hand.take(pet, {}, {0, 0}, 0);
    for (int i = 1; i <= 30; ++i) {
        hand.move({8 * i, -4 * i}, i * 8 * ms);
    }
    const Vec2 velocity = hand.throw_velocity(30 * 8 * ms, no_limit);
    CHECK(velocity.x == doctest::Approx(1000.0));
    CHECK(velocity.y == doctest::Approx(-500.0));
}

TEST_CASE("only the last 100 ms count") {
    Hand hand;
    hand.take(pet, {}, {0, 0}, 0);
    for (int i = 1; i <= 20; ++i) {
        hand.move({50 * i, 0}, i * 10 * ms);
    }
    for (int i = 1; i <= 11; ++i) {
        hand.move({1000 - 10 * i, 0}, (200 + i * 10) * ms);
    }
    CHECK(hand.throw_velocity(310 * ms, no_limit).x == doctest::Approx(-1000.0));
}

TEST_CASE("a hand that stands still drops") {
    Hand hand;
    hand.take(pet, {}, {0, 0}, 0);
    hand.move({50, 0}, 10 * ms);
    hand.move({100, 0}, 20 * ms);
    CHECK(hand.throw_velocity(21 * ms, no_limit).x > 1000.0);
    CHECK(hand.throw_velocity(101 * ms, no_limit) == Vec2{});
}

TEST_CASE("a throw is shortened to the limit and keeps its direction") {
    Hand hand;
    hand.take(pet, {}, {0, 0}, 0);
    hand.move({300, -400}, 10 * ms);
    const Vec2 velocity = hand.throw_velocity(10 * ms, 1000.0);
    CHECK(velocity.x == doctest::Approx(600.0));
    CHECK(velocity.y == doctest::Approx(-800.0));
}

TEST_CASE("samples of one moment give no velocity instead of an infinite one") {
    Hand hand;
    hand.take(pet, {}, {0, 0}, 5 * ms);
    hand.move({500, 500}, 5 * ms);
    CHECK(hand.throw_velocity(5 * ms, no_limit) == Vec2{});
}

TEST_CASE("a click is short and stays in place") {
    Hand hand;
    hand.take(pet, {}, {100, 100}, 0);
    hand.move({103, 98}, 50 * ms);
    CHECK(hand.was_click(100 * ms));
    CHECK_FALSE(hand.was_click(500 * ms));
    hand.move({120, 98}, 60 * ms);
    hand.move({100, 100}, 70 * ms);
    CHECK_FALSE(hand.was_click(100 * ms));
}
