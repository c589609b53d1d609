// SPDX-License-Identifier: MIT
#include "daemon/core/config_advice.h"

#include <fmt/format.h>

#include <cmath>

namespace hyrax {
namespace {

// The drop by which a law is judged: about the height of a screen.
constexpr double drop_height = 1000.0;
constexpr double soon = 0.5;         // [s]
constexpr double late = 300.0;       // [s]
constexpr double slow_fall = 100.0;  // [px/s]

struct Drop {
    double landing = infinity;  // [s]
    double rest = infinity;     // [s]
};

Drop drop(const Law& law) {
    const FreeSpace space({Obstacle{.top = drop_height}});
    Trajectory body;
    body.launch(0, {}, {}, law, space);
    Drop result;
    const Ticks end = from_seconds(2.0 * late);
    body.advance(end, law, space, [&result](const TrajectoryEvent& event) {
        if (event.kind == ContactKind::floor && result.landing == infinity) {
            result.landing = to_seconds(event.time);
        }
        result.rest = to_seconds(event.time);
    });
    if (body.mode() != Mode::rest) {
        result.rest = infinity;
    }
    return result;
}

// How the law moves a pet, whatever integrates it.
void on_the_law(const PhysicsConstants& set, const Law& law, std::vector<std::string>& lines) {
    if (law.gravity == 0.0) {
        return;
    }
    const Drop fallen = drop(law);
    if (fallen.rest < soon) {
        lines.push_back(fmt::format(
            "/physics/gravity: {:g} px/s^2 is strong: a pet rests within {:.2g} s of a drop of "
            "{:g} px",
            set.gravity,
            fallen.rest,
            drop_height
        ));
    } else if (fallen.rest > late && fallen.landing < late) {
        lines.push_back(fmt::format(
            "/physics/restitution: with {:g} a pet still bounces {:g} s after a drop of {:g} px, "
            "and "
            "frames are drawn as long as one moves",
            set.restitution,
            late,
            drop_height
        ));
    }
    const double terminal = law.gravity / law.drag;
    if (law.drag > 0.0 && terminal < slow_fall) {
        lines.push_back(fmt::format(
            "/physics/air_drag: {:g} is thick air: no pet falls faster than {:.3g} px/s",
            set.air_drag,
            terminal
        ));
    }
}

// What the chosen integrator makes of it.
void on_the_integrator(
    const EngineSettings& settings, const Law& law, double fps, std::vector<std::string>& lines
) {
    if (settings.forces != ForceField{} && settings.integrator != Integrator::rk45) {
        lines.push_back(
            "/physics/quadratic_drag: a drag that has no closed form is integrated by rk45 instead "
            "of the integrator that is set"
        );
    }
    const double stiffness = law.drag;
    // An explicit Runge-Kutta pair is stable up to 3.3 / drag; ten steps a frame are no bargain.
    if (settings.integrator == Integrator::rk45 && stiffness > 33.0 * fps) {
        lines.push_back(fmt::format(
            "/physics/integrator: air_drag {:g} is stiff for rk45, which takes {:.2g} steps a "
            "second for it; event_driven and exponential_swept take none",
            settings.physics.air_drag,
            stiffness / 3.3
        ));
    }
    const bool fixed = settings.integrator == Integrator::semi_implicit_euler_fixed;
    const bool verlet = settings.integrator == Integrator::stormer_verlet;
    const double steps = fixed ? settings.fixed_rate : fps;
    if ((fixed || verlet) && stiffness > steps) {
        lines.push_back(fmt::format(
            "/physics/integrator: air_drag {:g} decays within one of {:g} steps a second, so that "
            "falls have a wrong speed; event_driven and exponential_swept have the right one",
            settings.physics.air_drag,
            steps
        ));
    }
    const bool document = settings.integrator == Integrator::semi_implicit_euler;
    // What one step of gravity adds is lost at each impact.
    if ((document || fixed) && law.gravity / steps > 200.0) {
        lines.push_back(fmt::format(
            "/physics/integrator: gravity adds {:.3g} px/s in a step, and rebounds slower than "
            "that are lost; event_driven loses none",
            law.gravity / steps
        ));
    }
}

}  // namespace

std::vector<std::string> advice_on(const EngineSettings& settings, double fps) {
    const Law law = law_from(settings.physics, settings.reference_rate);
    std::vector<std::string> lines;
    on_the_law(settings.physics, law, lines);
    on_the_integrator(settings, law, fps, lines);
    return lines;
}

}  // namespace hyrax
