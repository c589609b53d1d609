// SPDX-License-Identifier: MIT
#include "daemon/core/config_advice.h"

#include <doctest/doctest.h>

using namespace hyrax;

namespace {

std::string only_line(const EngineSettings& settings) {
    const std::vector<std::string> lines = advice_on(settings, 60.0);
    REQUIRE(lines.size() == 1);
    return lines.front();
}

}  // namespace

TEST_CASE("advice: ordinary settings need none") {
    CHECK(advice_on({}, 60.0).empty());
    for (const double gravity : {0.0, 300.0, 5000.0}) {
        CHECK(advice_on({.physics = {.gravity = gravity}}, 60.0).empty());
    }
    CHECK(advice_on({.integrator = Integrator::semi_implicit_euler}, 60.0).empty());
    CHECK(advice_on({.integrator = Integrator::rk45}, 144.0).empty());
    CHECK(advice_on({.integrator = Integrator::semi_implicit_euler_fixed}, 24.0).empty());
}

TEST_CASE("advice: strong gravity is explained by when a pet rests") {
    CHECK(
        only_line({.physics = {.gravity = 1e9}}) ==
        "/physics/gravity: 1e+09 px/s^2 is strong: a pet rests within 0.0056 s of a drop of 1000 px"
    );
}

TEST_CASE("advice: what never rests says so") {
    const PhysicsConstants elastic{.restitution = 1.0, .air_drag = 1.0, .ground_friction = 1.0};
    CHECK(only_line({.physics = elastic})
              .starts_with("/physics/restitution: with 1 a pet still bounces"));
}

TEST_CASE("advice: a force without closed form says who integrates it") {
    CHECK(only_line({.forces = {.wind = {}, .quadratic_drag = 0.001}}
    ).starts_with("/physics/quadratic_drag: "));
    CHECK(advice_on(
              {.integrator = Integrator::rk45, .forces = {.wind = {}, .quadratic_drag = 0.001}},
              60.0
    )
              .empty());
}

TEST_CASE("advice: thick air is explained by the fastest fall") {
    CHECK(
        only_line({.physics = {.air_drag = 0.01}}) ==
        "/physics/air_drag: 0.01 is thick air: no pet falls faster than 4.34 px/s"
    );
}

TEST_CASE("advice: an integrator that the scene is too stiff for is named") {
    const PhysicsConstants stiff{.gravity = 1e6, .air_drag = 1e-20};
    const auto names = [&](Integrator integrator) {
        for (const std::string& line :
             advice_on({.physics = stiff, .integrator = integrator}, 60.0)) {
            if (line.starts_with("/physics/integrator: ")) {
                return true;
            }
        }
        return false;
    };
    CHECK(names(Integrator::rk45));
    CHECK(names(Integrator::stormer_verlet));
    CHECK(names(Integrator::semi_implicit_euler_fixed));
    CHECK(names(Integrator::semi_implicit_euler));
    CHECK_FALSE(names(Integrator::event_driven));
    CHECK_FALSE(names(Integrator::exponential_swept));
}
