// SPDX-License-Identifier: MIT
// What a throw makes of the hand's last moments, whatever the pointer's rate.
#include "physics/spring.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace hyrax;

namespace {

constexpr Ticks ms = ticks_per_ms;
constexpr double no_limit = std::numeric_limits<double>::infinity();

// A hand that has moved evenly for a while; its last sample was `silence` ago.
Vec2 thrown(Vec2 hand, Ticks interval, Ticks silence, const SpringConstants& constants = {}) {
    Spring spring(constants);
    REQUIRE(spring.grab({}, {}, 0));
    Ticks time = 0;
    while (time < 600 * ms) {
        time += interval;
        REQUIRE(spring.follow(hand * to_seconds(time), time));
    }
    return spring.release_velocity(time + silence, no_limit);
}

double length(Vec2 v) {
    return std::hypot(v.x, v.y);
}

}  // namespace

TEST_CASE("throw: an even hand gives its velocity at any rate of the pointer and any moment") {
    const Vec2 hand{900.0, -1200.0};
    for (const int rate : {25, 30, 40, 60, 90, 125, 250, 500, 1000, 4000, 8000}) {
        const Ticks interval = ticks_per_second / rate;
        for (int eighth = 0; eighth < 8; ++eighth) {
            CAPTURE(rate);
            CAPTURE(eighth);
            const Vec2 miss = thrown(hand, interval, interval * eighth / 8) - hand;
            CHECK(length(miss) < 1e-6 * length(hand));
        }
    }
}

TEST_CASE("throw: a hand that has stopped drops the body, sooner the oftener the pointer speaks") {
    for (const int rate : {30, 40, 60, 125, 1000}) {
        CAPTURE(rate);
        const Ticks interval = ticks_per_second / rate;
        const Ticks settled = std::max<Ticks>(2 * interval, ticks_per_second / 60) + 40 * ms;
        CHECK(thrown({900.0, -1200.0}, interval, settled) == Vec2{});
        // On the way there it only slows down.
        double before = no_limit;
        for (Ticks silence = interval; silence < settled; silence += 2 * ms) {
            const double speed = length(thrown({900.0, -1200.0}, interval, silence));
            CHECK(speed <= before + 1e-9);
            before = speed;
        }
    }
}

TEST_CASE("throw: samples that come late and in pairs give the same throw") {
    std::mt19937_64 random(21);
    for (int round = 0; round < 200; ++round) {
        Spring spring;
        REQUIRE(spring.grab({}, {}, 0));
        Ticks time = 0;
        for (int i = 0; i < 40; ++i) {
            time += 8 * ms;
            // A machine that is busy hands every second sample over with the next one.
            const Ticks heard = i % 2 == 0 ? time + 8 * ms : time;
            REQUIRE(spring.follow({to_seconds(time) * 800.0, 0.0}, heard));
        }
        const Ticks silence = static_cast<Ticks>(random() % (8 * ms));
        CHECK(spring.release_velocity(time + 8 * ms + silence, no_limit).x > 500.0);
    }
}

TEST_CASE("throw: a flick out of a pause is not slowed by the pause") {
    Spring spring;
    REQUIRE(spring.grab({}, {}, 0));
    double x = 0.0;
    for (Ticks time = 1000 * ms; time <= 1032 * ms; time += 8 * ms) {
        x += 16.0;  // 2000 px/s
        REQUIRE(spring.follow({x, 0.0}, time));
    }
    CHECK(spring.release_velocity(1034 * ms, no_limit).x > 1700.0);
    CHECK(spring.release_velocity(1034 * ms, no_limit).x < 2300.0);
}

TEST_CASE("throw: what is let go where it was grabbed keeps what the spring has left of its speed"
) {
    Spring spring;
    REQUIRE(spring.grab({{5.0, 6.0}, {300.0, 0.0}}, {5.0, 6.0}, 7 * ms));
    CHECK(spring.release_velocity(7 * ms, no_limit) == Vec2{300.0, 0.0});
    CHECK(spring.release_velocity(9 * ms, no_limit).x < 300.0);
    CHECK(spring.release_velocity(9 * ms, no_limit).x > 200.0);
    CHECK(std::fabs(spring.release_velocity(107 * ms, no_limit).x) < 1.0);
}
