// SPDX-License-Identifier: MIT
#include "tests/bench/bench_energy.h"

#include "tests/bench/meter.h"
#include "tests/bench/movers.h"

#include <fmt/format.h>

#include <cmath>
#include <ostream>

namespace hyrax::bench {
namespace {

constexpr PhysicsConstants elastic{
    .restitution = 1.0, .air_drag = 1.0, .ground_friction = 1.0, .rest_threshold = 5.0
};
constexpr Size room{1792, 952};
// Twice the speed is no multiple of what gravity adds in a frame: the document's errors would
// cancel.
constexpr Vec2 velocity{600.0, 7.0};
constexpr double tolerance = 1e-10;
constexpr double samples_per_decade = 16.0;
constexpr int rates[] = {60, 240};

double energy_of(const BodyState& state, const BodyScene& scene) {
    const Vec2 v = state.velocity;
    const double height = scene.room.height - state.position.y;
    return 0.5 * (v.x * v.x + v.y * v.y) + scene.law.gravity * height;
}

double run(Method method, const BodyScene& scene, int rate, long frames, std::ostream& csv) {
    return with_mover(method, scene, tolerance, [&](auto mover) {
        const double first = energy_of(mover.state(), scene);
        double error = 0.0;
        double next_sample = 1.0;
        for (long frame = 1; frame <= frames; ++frame) {
            mover.go_to(frame * ticks_per_second / rate, 1.0 / rate);
            if (static_cast<double>(frame) < next_sample && frame != frames) {
                continue;
            }
            next_sample *= std::pow(10.0, 1.0 / samples_per_decade);
            error = energy_of(mover.state(), scene) / first - 1.0;
            csv << fmt::format("{},{},{},{:.6e}\n", name_of(method), rate, frame, error);
        }
        return error;
    });
}

}  // namespace

void energy(std::ostream& table, std::ostream& csv, long frames) {
    const BodyScene scene = box_scene(elastic, room, {100.0, 0.0}, velocity);
    Progress progress("energy", methods.size() * std::size(rates));
    csv << "method,rate,frame,relative_error\n";
    table << fmt::format("Relative error of energy after {} frames, elastic and undamped\n", frames)
          << fmt::format("{:<22}{:>12}{:>12}\n", "integrator", "60 Hz", "240 Hz");
    for (const auto& [method, name] : methods) {
        table << fmt::format("{:<22}", name);
        for (const int rate : rates) {
            table << fmt::format("{:>12.2e}", run(method, scene, rate, frames, csv));
            progress.step();
        }
        table << '\n' << std::flush;
    }
}

}  // namespace hyrax::bench
