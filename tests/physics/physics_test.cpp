// SPDX-License-Identifier: MIT
#include "physics/physics.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace hyrax;

namespace {

// Powers of two all over: every step is exact, so the expected values are what a pencil gives.
constexpr PhysicsConstants dyadic{
    .gravity = 8.0,
    .restitution = 0.5,
    .air_drag = 0.5,
    .ground_friction = 0.25,
    .rest_threshold = 1.0,
};

physics body(double x, double y, double vx, double vy, const PhysicsConstants& constants = dyadic) {
    physics made(x, y, vx, vy);
    made.setConstants(constants);
    return made;
}

void check_state(const physics& p, double x, double y, double vx, double vy) {
    CHECK(p.x() == x);
    CHECK(p.y() == y);
    CHECK(p.vx() == vx);
    CHECK(p.vy() == vy);
}

}  // namespace

TEST_CASE("a body begins where it is put") {
    check_state(physics(), 0.0, 0.0, 0.0, 0.0);
    check_state(physics(1.0, 2.0), 1.0, 2.0, 0.0, 0.0);
    check_state(physics(1.0, 2.0, 3.0, 4.0), 1.0, 2.0, 3.0, 4.0);
}

TEST_CASE("the constants are the document's") {
    CHECK(physics::GRAVITY == 1200.0);
    CHECK(physics::RESTITUTION == 0.6);
    CHECK(physics::AIR_DRAG == 0.999);
    CHECK(physics::GROUND_FRICTION == 0.8);
    CHECK(physics::REST_THRESHOLD == 5.0);
    CHECK(physics().constants() == PhysicsConstants{});
}

TEST_CASE("setters set what they name and nothing else") {
    physics p(1.0, 2.0, 3.0, 4.0);
    p.setPos(10.0, 20.0);
    check_state(p, 10.0, 20.0, 3.0, 4.0);
    p.setVelocity(30.0, 40.0);
    check_state(p, 10.0, 20.0, 30.0, 40.0);
    p.resetVelocity();
    check_state(p, 10.0, 20.0, 0.0, 0.0);
}

TEST_CASE("one frame is gravity, then drag, then position") {
    // vy = (2 + 8 * 0.5) * 0.5 = 3; vx = 4 * 0.5 = 2; x = 10 + 2 * 0.5; y = 20 + 3 * 0.5.
    physics p = body(10.0, 20.0, 4.0, 2.0);
    p.update(0.5, 1000, 1000, 100, 100);
    check_state(p, 11.0, 21.5, 2.0, 3.0);
}

TEST_CASE("the left wall reflects and leaves the vertical velocity alone") {
    // vx = -32 * 0.5 = -16, x = 2 - 8 < 0.
    physics p = body(2.0, 20.0, -32.0, 2.0);
    p.update(0.5, 1000, 1000, 100, 100);
    check_state(p, 0.0, 21.5, 8.0, 3.0);
}

TEST_CASE("the right wall stands at the screen's width minus the object's") {
    // x = 898 + 8 > 900.
    physics p = body(898.0, 20.0, 32.0, 2.0);
    p.update(0.5, 1000, 1000, 100, 100);
    check_state(p, 900.0, 21.5, -8.0, 3.0);

    // Just touching is no collision.
    physics touching = body(892.0, 20.0, 32.0, 2.0);
    touching.update(0.5, 1000, 1000, 100, 100);
    check_state(touching, 900.0, 21.5, 16.0, 3.0);
}

TEST_CASE("the top edge reflects without friction") {
    // vy = (-36 + 4) * 0.5 = -16, y = 2 - 8 < 0.
    physics p = body(10.0, 2.0, 4.0, -36.0);
    p.update(0.5, 1000, 1000, 100, 100);
    check_state(p, 11.0, 0.0, 2.0, 8.0);
}

TEST_CASE("the ground reflects and takes horizontal speed") {
    // vy = (28 + 4) * 0.5 = 16, y = 899 + 8 > 900; vx = 4 * 0.5 * 0.25.
    physics p = body(10.0, 899.0, 4.0, 28.0);
    p.update(0.5, 1000, 1000, 100, 100);
    check_state(p, 11.0, 900.0, 0.5, -8.0);
}

TEST_CASE("a rebound slower than the threshold stops, one at the threshold does not") {
    // vy = (-1 + 4) * 0.5 = 1.5, rebound 0.75 < 1.
    physics slow = body(10.0, 900.0, 0.0, -1.0);
    slow.update(0.5, 1000, 1000, 100, 100);
    check_state(slow, 10.0, 900.0, 0.0, 0.0);

    // vy = (0 + 4) * 0.5 = 2, rebound exactly 1.
    physics at_threshold = body(10.0, 900.0, 0.0, 0.0);
    at_threshold.update(0.5, 1000, 1000, 100, 100);
    check_state(at_threshold, 10.0, 900.0, 0.0, -1.0);
}

TEST_CASE("fast rebounds bounce: the threshold compares the speed, as the document's code does") {
    // After the reflection vy is never positive; the text's `v_y < eps` would stop every bounce.
    physics p = body(10.0, 899.0, 0.0, 100.0);
    p.update(0.5, 1000, 1000, 100, 100);
    CHECK(p.vy() == -26.0);
}

TEST_CASE("the position is the top-left corner: the bounds are 0 and screen minus object") {
    physics p(5000.0, 5000.0);
    p.update(1.0 / 60.0, 1920, 1080, 128, 96);
    CHECK(p.x() == 1920.0 - 128.0);
    CHECK(p.y() == 1080.0 - 96.0);
}

TEST_CASE("restitution is a ratio of speeds, so a bounce keeps its square of the energy") {
    physics p =
        body(10.0, 900.0, 0.0, 100.0, {.gravity = 0.0, .restitution = 0.6, .air_drag = 1.0});
    p.update(0.5, 1000, 1000, 100, 100);
    CHECK(p.vy() == -60.0);
    CHECK(p.vy() * p.vy() == doctest::Approx(0.36 * 100.0 * 100.0));
}

// Computed by an independent program in IEEE double precision, one rounding for each operation.
TEST_CASE("the document's scene, bit for bit") {
    physics p(100.0, 0.0, 600.0, 0.0);
    const auto run = [&p](int frames) {
        for (int i = 0; i < frames; ++i) {
            p.update(1.0 / 60.0, 1920, 1080, 128, 128);
        }
    };
    run(1);
    check_state(
        p, 0x1.b7f5c28f5c28fp+6, 0x1.54fdf3b645a1dp-2, 0x1.2bb3333333333p+9, 0x1.3fae147ae147bp+4
    );
    run(1);
    check_state(
        p, 0x1.dfe14a4d2b2c0p+6, 0x1.ff5147f130596p-1, 0x1.2b667a0f9096cp+9, 0x1.3f852934acb00p+5
    );
    run(58);
    check_state(
        p, 0x1.550701bbad974p+9, 0x1.2ac9dfe31ea1ap+9, 0x1.1a85584de7bcap+9, 0x1.230701bbad973p+10
    );
    run(17);
    check_state(p, 0x1.a45bbcf79494dp+9, 952.0, 0x1.bc68f64c25ffdp+8, -0x1.bc6e15f5e57f3p+9);
    run(223);
    check_state(p, 0x1.aa8a176cbff17p+10, 952.0, -0x1.0e6b796dbf42ap-2, -0x1.dfb2eeb7b607ep+2);
}

TEST_CASE("each body has its own constants") {
    physics light = body(0.0, 0.0, 0.0, 0.0, {.gravity = 100.0});
    physics heavy = body(0.0, 0.0, 0.0, 0.0, {.gravity = 2000.0});
    light.update(0.01, 1000, 1000, 10, 10);
    heavy.update(0.01, 1000, 1000, 10, 10);
    CHECK(heavy.vy() == doctest::Approx(20.0 * light.vy()));
}
