// SPDX-License-Identifier: MIT
#include "physics/spring.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace hyrax;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr Ticks ms = ticks_per_ms;
constexpr Ticks frame = ticks_per_second / 60;
constexpr SpringBody at_origin{};

/// Every row of spring.csv as its fields; make_spring_references.py says what they are.
std::vector<std::vector<std::string>> references() {
    std::ifstream file(HYRAX_SOURCE_DIR "/tests/golden/spring.csv");
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(file, line);) {
        std::vector<std::string>& fields = rows.emplace_back();
        std::istringstream stream(line);
        for (std::string field; std::getline(stream, field, ',');) {
            fields.push_back(field);
        }
    }
    return rows;
}

double number(const std::string& field) {
    return std::strtod(field.c_str(), nullptr);
}

Spring held(const SpringConstants& constants, const SpringBody& body, Vec2 target, Ticks time = 0) {
    Spring spring(constants);
    REQUIRE(spring.grab(body, target, time));
    return spring;
}

// A sum with an infinity or NaN in it is not finite.
bool finite(const SpringMatrix& m) {
    return std::isfinite(m.a11 + m.a12 + m.a21 + m.a22);
}

bool finite(const SpringBody& body) {
    return std::isfinite(body.position.x + body.position.y + body.velocity.x + body.velocity.y);
}

/// The largest difference on (e, e'/w).
double difference(const SpringMatrix& m, const SpringMatrix& n, double w) {
    return std::max(
        {std::fabs(m.a11 - n.a11),
         w * std::fabs(m.a12 - n.a12),
         std::fabs(m.a21 - n.a21) / w,
         std::fabs(m.a22 - n.a22)}
    );
}

SpringMatrix product(const SpringMatrix& m, const SpringMatrix& n) {
    return {
        m.a11 * n.a11 + m.a12 * n.a21,
        m.a11 * n.a12 + m.a12 * n.a22,
        m.a21 * n.a11 + m.a22 * n.a21,
        m.a21 * n.a12 + m.a22 * n.a22
    };
}

/// zeta from 0 to 1e3 with many close to 1, w t from 1e-4 to 2000.
struct RandomSpring {
    SpringConstants constants;
    double seconds = 0.0;
};

RandomSpring random_spring(std::mt19937_64& random) {
    const auto power = [&](double low, double high) {
        return std::pow(10.0, std::uniform_real_distribution(low, high)(random));
    };
    const double w = power(-1.0, 5.0);
    const double distance = power(-16.0, -1.0);
    const std::array zetas{1.0 - distance, 1.0 + distance, 0.0, power(-3.0, 3.0)};
    const double zeta = zetas[std::min<std::size_t>(random() % 6, 3)];
    return {{w, zeta}, power(-4.0, 3.3) / w};
}

}  // namespace

TEST_CASE("the propagator agrees with 60 digits") {
    double near_critical = 0.0;
    double wide = 0.0;
    int rows = 0;
    for (const std::vector<std::string>& row : references()) {
        if (row[0] != "matrix") {
            continue;
        }
        const double zeta = number(row[1]);
        const double w = number(row[2]);
        const double error = difference(
            propagator({w, zeta}, number(row[3])),
            {number(row[4]), number(row[5]) / w, number(row[6]) * w, number(row[7])},
            w
        );
        double& worst = std::fabs(zeta - 1.0) < 0.11 ? near_critical : wide;
        worst = std::max(worst, error);
        ++rows;
    }
    CHECK(rows > 400);
    MESSAGE("zeta near 1: ", near_critical, ", zeta to 1e3 and w t to 2000: ", wide);
    CHECK(near_critical < 6e-16);
    CHECK(wide < 1e-12);
}

TEST_CASE("a held body agrees with 60 digits, on both axes") {
    Spring spring;
    double scale = 0.0;
    double worst_position = 0.0;
    double worst_velocity = 0.0;
    int reads = 0;
    for (const std::vector<std::string>& row : references()) {
        if (row[0] == "track") {
            spring = Spring({number(row[2]), number(row[1])});
            const Vec2 position{number(row[3]), -number(row[3])};
            const Vec2 velocity{number(row[4]), -number(row[4])};
            const Vec2 target{number(row[5]), -number(row[5])};
            REQUIRE(spring.grab({position, velocity}, target, std::stoll(row[6])));
            scale = number(row[2]);
        } else if (row[0] == "sample") {
            REQUIRE(spring.follow({number(row[2]), -number(row[2])}, std::stoll(row[1])));
        } else if (row[0] == "read") {
            const SpringBody body = spring.at(std::stoll(row[1]));
            // Neither axis knows of the other, and both are mirrored bit for bit.
            CHECK(body.position.x == -body.position.y);
            CHECK(body.velocity.x == -body.velocity.y);
            worst_position = std::max(worst_position, std::fabs(body.position.x - number(row[2])));
            worst_velocity =
                std::max(worst_velocity, std::fabs(body.velocity.x - number(row[3])) / scale);
            ++reads;
        }
    }
    CHECK(reads > 1500);
    MESSAGE("position: ", worst_position, " px, velocity / w: ", worst_velocity, " px");
    CHECK(worst_position < 1e-9);
    CHECK(worst_velocity < 1e-9);
}

TEST_CASE("S11: no spring drifts, a stiff spring is at the cursor, endless damping stays") {
    CHECK(propagator({0.0, 1.0}, 2.0) == SpringMatrix{1.0, 2.0, 0.0, 1.0});
    CHECK(propagator({1e300, 1.0}, 1e-3) == SpringMatrix{0.0, 0.0, 0.0, 0.0});
    CHECK(propagator({1e300, 0.3}, 1e-3) == SpringMatrix{0.0, 0.0, 0.0, 0.0});
    const SpringMatrix stays = propagator({100.0, 1e200}, 10.0);
    CHECK(stays.a11 == 1.0);
    CHECK(std::fabs(stays.a12) < 1e-200);
    CHECK(std::fabs(stays.a21) < 1e-190);
    CHECK(std::fabs(stays.a22) < 1e-200);
}

TEST_CASE("no time is the identity, and hostile numbers stay finite") {
    const double values[] = {
        0.0, 5e-324, 0.3, 1.0 - 0x1p-53, 1.0, 1.0 + 0x1p-52, 60.0, 1e154, 1e300
    };
    for (const double w : values) {
        for (const double zeta : values) {
            CAPTURE(w);
            CAPTURE(zeta);
            CHECK(propagator({w, zeta}, 0.0) == SpringMatrix{});
            CHECK(propagator({w, zeta}, -1.0) == SpringMatrix{});
            CHECK(propagator({w, zeta}, not_a_number) == SpringMatrix{});
            for (const double seconds : values) {
                CAPTURE(seconds);
                CHECK(finite(propagator({w, zeta}, seconds)));
            }
            CHECK(finite(propagator({w, zeta}, infinity)));
        }
    }
}

TEST_CASE("S12: constants that are no spring hold rigidly on the target") {
    for (const double bad : {infinity, -infinity, not_a_number, -1.0}) {
        for (const SpringConstants& rigid :
             {SpringConstants{bad, 1.0}, {60.0, bad}, {1e300, 1.0}}) {
            CHECK(propagator(rigid, 0.01) == SpringMatrix{0.0, 0.0, 0.0, 0.0});
            Spring spring = held(rigid, {{50.0, 60.0}, {700.0, 0.0}}, {100.0, 200.0});
            CHECK(spring.at(0) == SpringBody{{100.0, 200.0}, {}});
            REQUIRE(spring.follow({108.0, 200.0}, 8 * ms));
            CHECK(spring.at(12 * ms).position.x == doctest::Approx(104.0));
            CHECK(spring.at(12 * ms).velocity.x == doctest::Approx(1000.0));
            CHECK(spring.at(60 * ms) == SpringBody{{108.0, 200.0}, {}});
        }
    }
}

TEST_CASE("two steps are one step, and energy never grows") {
    std::mt19937_64 random(11);
    double worst = 0.0;
    double gain = 0.0;
    for (int i = 0; i < 20'000; ++i) {
        const auto [constants, seconds] = random_spring(random);
        const double w = constants.frequency;
        const double first = seconds * std::uniform_real_distribution(0.0, 1.0)(random);
        const SpringMatrix whole = propagator(constants, seconds);
        const SpringMatrix parts =
            product(propagator(constants, seconds - first), propagator(constants, first));
        worst = std::max(worst, difference(whole, parts, w));

        const double angle = std::uniform_real_distribution(0.0, 6.3)(random);
        const double e = whole.a11 * std::cos(angle) + whole.a12 * w * std::sin(angle);
        const double rate = whole.a21 / w * std::cos(angle) + whole.a22 * std::sin(angle);
        gain = std::max(gain, e * e + rate * rate - 1.0);
    }
    MESSAGE("semigroup: ", worst, ", energy gain: ", gain);
    CHECK(worst < 1e-12);
    CHECK(gain < 2e-15);
}

TEST_CASE("a body pulled from rest by a damping ratio of 1 or more never swings over") {
    std::mt19937_64 random(12);
    for (int i = 0; i < 300; ++i) {
        const double w = std::pow(10.0, std::uniform_real_distribution(0.0, 4.0)(random));
        const double above = std::pow(10.0, std::uniform_real_distribution(-16.0, 2.0)(random));
        const double zeta = i % 4 == 0 ? 1.0 : 1.0 + above;
        CAPTURE(w);
        CAPTURE(zeta);
        const Spring spring = held({w, zeta}, {{-300.0, 40.0}, {}}, {0.0, 0.0});
        double last = -300.0;
        for (Ticks time = 0; time < 2000 * ms; time = time * 5 / 4 + 1000) {
            const SpringBody body = spring.at(time);
            CHECK(body.position.x <= 0.0);
            CHECK(body.position.y >= 0.0);
            CHECK(body.position.x >= last);
            last = body.position.x;
        }
    }
}

TEST_CASE("the cursor's rest is the body's rest, whatever came before") {
    for (const double zeta : {0.3, 1.0, 4.0}) {
        Spring spring = held({60.0, zeta}, {{900.0, -50.0}, {-3000.0, 10.0}}, {10.0, 20.0});
        REQUIRE(spring.follow({70.0, -400.0}, 8 * ms));
        REQUIRE(spring.follow({-1234.0, 567.0}, 16 * ms));
        const SpringBody body = spring.at(10 * ticks_per_second);
        CHECK(std::fabs(body.position.x + 1234.0) < 1e-12);
        CHECK(std::fabs(body.position.y - 567.0) < 1e-12);
        CHECK(std::hypot(body.velocity.x, body.velocity.y) < 1e-12);
    }
}

TEST_CASE("a steady hand is followed one interval of the mouse late, with its own velocity") {
    for (const Ticks interval : {16 * ms, 8 * ms, ms, ms / 8}) {
        CAPTURE(interval);
        Spring spring = held({}, at_origin, {});
        Ticks time = 0;
        while (time < 500 * ms) {
            time += interval;
            REQUIRE(spring.follow({to_seconds(time) * 900.0, to_seconds(time) * -300.0}, time));
        }
        for (Ticks after = 0; after <= interval; after += interval / 4) {
            const SpringBody body = spring.at(time + after);
            const double lag = to_seconds(std::max(interval, Spring::min_glide));
            const double expected = 900.0 * (to_seconds(time + after) - lag);
            CHECK(std::fabs(body.position.x - expected) < 1e-9);
            CHECK(std::fabs(body.position.x - spring.target(time + after).x) < 1e-9);
            CHECK(std::fabs(body.velocity.x - 900.0) < 1e-6);
            CHECK(std::fabs(body.velocity.y + 300.0) < 1e-6);
        }
        CHECK(spring.at(time + 40 * ms).velocity.x < 0.0);
        CHECK(spring.release_velocity(time + 40 * ms, 1e4) == Vec2{});
    }
}

TEST_CASE("the target is late by a frame at most and never ahead of the cursor") {
    std::mt19937_64 random(13);
    Spring spring = held({}, at_origin, {});
    Ticks time = 0;
    double x = 0.0;
    for (int i = 0; i < 2000; ++i) {
        time += static_cast<Ticks>(random() % (i % 5 == 0 ? 200 * ms : 9 * ms));
        x += static_cast<double>(random() % 40);
        REQUIRE(spring.follow({x, 0.0}, time));
        CHECK(spring.target(time + Spring::max_glide).x == x);
        CHECK(spring.target(time + Spring::max_glide / 2).x <= x);
    }
}

TEST_CASE("samples that were held up and come at once do not jerk the target") {
    Spring spring = held({}, at_origin, {});
    for (const Ticks time : {16 * ms, 32 * ms, 33 * ms, 34 * ms}) {
        REQUIRE(spring.follow({to_seconds(time), 0.0}, time));
    }
    CHECK((spring.target(35 * ms).x - spring.target(34 * ms).x) / 0.001 < 1.2);
    // What one hold has learned about the mouse does not reach the next.
    REQUIRE(spring.follow({}, 90 * ms));
    REQUIRE(spring.grab({}, {}, 100 * ms));
    REQUIRE(spring.follow({1.0, 0.0}, 102 * ms));
    CHECK(spring.target(104 * ms).x == 1.0);
}

TEST_CASE("position and velocity are continuous where lines meet") {
    Spring spring = held({}, {{20.0, 0.0}, {0.0, 500.0}}, {});
    Ticks time = 0;
    for (const Ticks step : {8 * ms, 3 * ms, 40 * ms, 8 * ms, Ticks{0}, 8 * ms}) {
        time += step;
        const SpringBody before = spring.at(time);
        REQUIRE(spring.follow({to_seconds(time) * 4000.0, 7.0}, time));
        const SpringBody after = spring.at(time);
        CHECK(std::fabs(after.position.x - before.position.x) < 1e-12);
        CHECK(std::fabs(after.velocity.x - before.velocity.x) < 1e-9);
        // 1 ns at 1e6 px/s^2.
        for (Ticks inside = 1; inside < 20 * ms; inside += ms / 2) {
            const Vec2 left = spring.at(time + inside - 1).velocity;
            const Vec2 right = spring.at(time + inside).velocity;
            CHECK(std::hypot(right.x - left.x, right.y - left.y) < 1e-2);
        }
    }
}

TEST_CASE("S14: the cursor leaps to another monitor and lets go in the next frame") {
    Spring spring = held({}, at_origin, {});
    REQUIRE(spring.follow({1e5, -2e4}, 8 * ms));
    const Vec2 free = spring.release_velocity(8 * ms + frame / 2, infinity);
    CHECK(std::hypot(free.x, free.y) > 1e5);
    const Vec2 capped = spring.release_velocity(8 * ms + frame / 2, 5000.0);
    CHECK(std::hypot(capped.x, capped.y) == doctest::Approx(5000.0));
    const double below = 0.9 * std::hypot(free.x, free.y);
    CHECK(spring.release_velocity(8 * ms + frame / 2, below).x == doctest::Approx(0.9 * free.x));
    CHECK(capped.x / capped.y == doctest::Approx(free.x / free.y));
    CHECK(finite(spring.at(8 * ms + frame)));
    // Below the limit nothing changes; a limit that is no speed lets nothing fly.
    CHECK(spring.release_velocity(8 * ms, infinity) == spring.at(8 * ms).velocity);
    CHECK(spring.release_velocity(9 * ms, not_a_number) == Vec2{});
    CHECK(spring.release_velocity(9 * ms, -1.0) == Vec2{});
}

TEST_CASE("A1, A5, A8: what is refused changes no bit") {
    Spring spring = held({}, {{3.0, 4.0}, {50.0, 60.0}}, {10.0, 20.0}, 5 * ms);
    REQUIRE(spring.follow({30.0, 25.0}, 13 * ms));
    Spring untouched = spring;
    for (const double bad : {not_a_number, infinity, -infinity, 1e13, -1e300}) {
        CHECK_FALSE(spring.follow({bad, 0.0}, 20 * ms));
        CHECK_FALSE(spring.follow({0.0, bad}, 20 * ms));
        CHECK_FALSE(spring.grab({{bad, 0.0}, {}}, {}, 20 * ms));
        CHECK_FALSE(spring.grab({{}, {0.0, bad}}, {}, 20 * ms));
        CHECK_FALSE(spring.grab({}, {bad, bad}, 20 * ms));
    }
    CHECK_FALSE(spring.follow({31.0, 25.0}, 12 * ms));
    const auto check_same = [&] {
        for (Ticks time = 0; time < 60 * ms; time += 777'777) {
            CHECK(spring.at(time) == untouched.at(time));
        }
    };
    check_same();
    REQUIRE(spring.follow({40.0, 30.0}, 21 * ms));
    REQUIRE(untouched.follow({40.0, 30.0}, 21 * ms));
    check_same();
}

TEST_CASE("reads change nothing: the same bits whenever and however often the body is looked at") {
    std::mt19937_64 random(14);
    Spring looked_at = held({90.0, 0.7}, {{5.0, 6.0}, {7.0, 8.0}}, {1.0, 2.0});
    Spring alone = looked_at;
    Ticks time = 0;
    double x = 0.0;
    for (int i = 0; i < 500; ++i) {
        for (std::uint64_t reads = random() % 6; reads > 0; --reads) {
            const Ticks when = time + static_cast<Ticks>(random() % (30 * ms)) - 5 * ms;
            CHECK(finite(looked_at.at(when)));
            CHECK(std::isfinite(looked_at.release_velocity(when, 1e7).x + looked_at.target(when).y)
            );
        }
        time += random() % 3 == 0 ? 8 * ms : static_cast<Ticks>(random() % (30 * ms));
        x = std::uniform_real_distribution(-2000.0, 2000.0)(random);
        REQUIRE(looked_at.follow({x, -x}, time));
        REQUIRE(alone.follow({x, -x}, time));
        CHECK(looked_at.at(time + frame) == alone.at(time + frame));
        CHECK(looked_at.at(time - ms) == alone.at(time));
        CHECK(alone.target(time + frame) == Vec2{x, -x});
    }
}

TEST_CASE("extreme moments and places stay finite") {
    constexpr Ticks first = std::numeric_limits<Ticks>::min();
    Spring spring = held({1e9, 0.0}, {{1e12, -1e12}, {-1e12, 1e12}}, {-1e12, 1e12}, first);
    for (const Ticks time : {first, first + 1, Ticks{0}, never - 1, never, never}) {
        REQUIRE(spring.follow({time % 2 == 0 ? 1e12 : -1e12, 1e12}, time));
        for (const Ticks read : {first, Ticks{0}, never}) {
            CHECK(finite(spring.at(read)));
        }
    }
}
