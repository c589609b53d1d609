// SPDX-License-Identifier: MIT
// One body in one scene, moved by the integrator of a column: what the cases are written against.
#pragma once

#include "physics/free_space.h"
#include "physics/runge_kutta.h"
#include "physics/trajectory.h"
#include "tests/bench/catalogue.h"

#include <memory>

namespace hyrax::bench {

/// Where the top-left corner may be [px]. The default one is that of a 128 px body on a screen of
/// 1920 x 1080; differences of sides are whole numbers.
struct Bounds {
    double left = 0.0;
    double top = 0.0;
    double right = 1792.0;
    double bottom = 952.0;

    double width() const { return right - left; }
};

/// No walls and no floor.
inline constexpr Bounds open{-infinity, -infinity, infinity, infinity};
/// A floor at 952 px and nothing else within reach.
inline constexpr Bounds open_floor{-1e6, -1e6, 1e6, 952.0};

/// The default is the document's: a throw to the right from the upper left corner.
struct Scene {
    PhysicsConstants constants{};  ///< For the document's column,
    Law law = law_from({});        ///< and the same as rates at 60 Hz for the others.
    Bounds bounds{};
    Vec2 position{100.0, 0.0};
    Vec2 velocity{600.0, 0.0};
    RungeKuttaSettings tolerances{};
    Ticks start = 0;  ///< Of the clock.

    static Scene of(const PhysicsConstants& constants) {
        return {.constants = constants, .law = law_from(constants)};
    }
};

class Runner {
public:
    virtual ~Runner() = default;
    virtual void advance(Ticks span) = 0;
    virtual BodyState state() const = 0;
    /// The walls move; the body goes on from where it is, as far as the new ones allow.
    virtual void confine(const Bounds& bounds) = 0;
    /// Closed-form flights and evaluations of the forces since the launch, at least so many.
    virtual long long work() const = 0;
};

std::unique_ptr<Runner> launch(Column column, const Scene& scene);

/// Moves on by whole frames at `rate` a second, and calls visit(state) after each of them. Frames
/// end at the ticks nearest to their times.
template <typename Visit>
void run(Runner& runner, double seconds, double rate, Visit visit) {
    const long long frames = std::llround(seconds * rate);
    Ticks now = 0;
    for (long long frame = 1; frame <= frames; ++frame) {
        const Ticks next = from_seconds(static_cast<double>(frame) / rate);
        runner.advance(next - now);
        now = next;
        visit(runner.state());
    }
}

inline BodyState run(Runner& runner, double seconds, double rate = 60.0) {
    run(runner, seconds, rate, [](const BodyState&) {});
    return runner.state();
}

/// Where a launch leads.
BodyState state_after(Column column, const Scene& scene, double seconds, double rate = 60.0);

/// Long enough for every scene of the catalogue that comes to rest.
inline constexpr double until_rest = 20.0;  // [s]
inline double rest_x(Column column, const Scene& scene, double rate = 60.0) {
    return state_after(column, scene, until_rest, rate).position.x;
}

inline double distance(Vec2 a, Vec2 b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// The larger error of two; an error that is not a number stays.
inline double worse(double a, double b) {
    return b > a || std::isnan(b) ? b : a;
}

/// The largest difference between results at the usual frame rates.
template <typename Result>
double spread_over_rates(Result result) {
    double low = infinity;
    double high = -infinity;
    for (const double rate : {24.0, 30.0, 60.0, 120.0, 144.0, 240.0}) {
        const double value = result(rate);
        low = std::fmin(low, value);
        high = worse(high, value);
    }
    return high - low;
}

}  // namespace hyrax::bench
