// SPDX-License-Identifier: MIT
#include "physics/time_of_impact.h"

#include "physics/flight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hyrax {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Drag that changes a parabola's times by less than a rounding is none.
constexpr double negligible_decay = 1e-17;
// e^-40 is below a rounding: what is left then is uniform motion.
constexpr double settled_decay = 40.0;
// Newton squares the relative error of a step, Halley cubes it: what follows a step of this size is
// below a rounding.
constexpr double newton_step = 3e-9;
constexpr double halley_step = 1e-6;
constexpr int most_iterations = 100;  // Bisection alone needs 60.

struct Bracket {
    double low;
    double high;
    bool holds(double t) const { return t > low && t < high; }
    double middle() const { return low + 0.5 * (high - low); }
};

double apex_time(double rising_speed, double gravity, double drag) {
    return drag == 0.0 ? rising_speed / gravity : std::log1p(drag * rising_speed / gravity) / drag;
}

// sqrt(v^2 + 2 g d) that survives speeds whose square overflows.
double speed_after_fall(double velocity, double gravity, double depth) {
    const double squared = velocity * velocity + 2.0 * gravity * depth;
    return std::isfinite(squared)
               ? std::sqrt(squared)
               : std::hypot(velocity, std::sqrt(2.0 * gravity) * std::sqrt(depth));
}

double parabola_fall_time(double depth, double velocity, double gravity) {
    const double arrival = speed_after_fall(velocity, gravity, depth);
    if (velocity < 0.0) {
        return (arrival - velocity) / gravity;
    }
    return depth == 0.0 ? 0.0 : 2.0 * (depth / (velocity + arrival));
}

// A hop off a floor and back onto it. The trivial root t = 0 is divided out, which leaves the mean
// velocity a(t) = -V phi1 + G t phi2, whose only root is the landing.
double hop_time(double speed, double gravity, double drag) {
    const double decay = drag * speed / gravity;
    if (decay < negligible_decay) {
        return 2.0 * speed / gravity;
    }
    // At the landing, t = (1 + decay) / drag * (1 - e^(-drag t)).
    Bracket bracket{0.0, (1.0 + decay) / drag};
    double t = decay < 0.3
                   ? 2.0 * speed / gravity *
                         (1.0 + decay * (-1.0 / 3.0 + decay * (2.0 / 9.0 - decay * 22.0 / 135.0)))
                   : -std::expm1(-(1.0 + decay)) * bracket.high;
    for (int i = 0; i < most_iterations; ++i) {
        const PhiFunctions phi = phi_functions(-drag * t);
        const double mean = gravity * t * phi.phi2 - speed * phi.phi1;
        const double velocity = gravity * t * phi.phi1 - speed * phi.exp;
        (mean < 0.0 ? bracket.low : bracket.high) = t;
        const double slope = (velocity - mean) / t;
        const double next = t - mean / slope;
        if (!bracket.holds(next)) {
            const double middle = bracket.middle();
            if (mean == 0.0 || middle == bracket.low || middle == bracket.high) {
                return t;
            }
            t = middle;
            continue;
        }
        const double step = std::fabs(next - t);
        t = next;
        if (step <= newton_step * t) {
            break;
        }
    }
    return t;
}

// The root of way(t) = target where `fly` rises through it; `sign` turns the axis.
double halley(
    double t, Bracket bracket, double velocity, double force, double drag, double target
) {
    if (!bracket.holds(t)) {
        t = bracket.middle();
    }
    for (int i = 0; i < most_iterations; ++i) {
        const AxisState now = fly(velocity, force, drag, t);
        const double miss = now.offset - target;
        if (miss == 0.0) {
            return t;
        }
        (miss < 0.0 ? bracket.low : bracket.high) = t;
        const double slope = now.velocity;
        const double curvature = force - drag * now.velocity;
        const double next = t - 2.0 * miss * slope / (2.0 * slope * slope - miss * curvature);
        if (!bracket.holds(next)) {
            const double middle = bracket.middle();
            if (middle == bracket.low || middle == bracket.high ||
                std::fabs(next - t) <= 2e-16 * t) {
                return t;
            }
            t = middle;
            continue;
        }
        const double step = std::fabs(next - t);
        t = next;
        if (step <= halley_step * t) {
            break;
        }
    }
    return t;
}

double drop_time(double depth, double velocity, double gravity, double drag) {
    const double parabola = parabola_fall_time(depth, velocity, gravity);
    if (drag * parabola < negligible_decay) {
        return parabola;
    }
    const double terminal = gravity / drag;
    // The asymptote of the motion. Under stiff drag Newton's terms cancel on it.
    const double uniform = (depth + (terminal - velocity) / drag) / terminal;
    if (drag * uniform > settled_decay) {
        return uniform;
    }
    const Bracket bracket{0.0, velocity < terminal ? uniform : depth / terminal};
    return halley(parabola, bracket, velocity, gravity, drag, depth);
}

}  // namespace

double glide_time(double distance, double speed, double drag) {
    const double uniform = distance / speed;
    const double share = drag * uniform;
    if (share == 0.0) {
        return uniform;
    }
    return share >= 1.0 ? infinity : -std::log1p(-share) / drag;
}

double decay_time(double speed, double slower, double drag) {
    return drag == 0.0 ? infinity : std::max(0.0, std::log(speed / slower) / drag);
}

double fall_time(double depth, double velocity, double gravity, double drag) {
    if (gravity == 0.0) {
        return velocity > 0.0 && depth >= 0.0 ? glide_time(depth, velocity, drag) : infinity;
    }
    if (depth < 0.0) {
        if (velocity >= 0.0) {
            return infinity;
        }
        const double apex = apex_time(-velocity, gravity, drag);
        const double below = depth - fly(velocity, gravity, drag, apex).offset;
        return below < 0.0 ? infinity : apex + drop_time(below, 0.0, gravity, drag);
    }
    if (depth == 0.0) {
        return velocity < 0.0 ? hop_time(-velocity, gravity, drag) : 0.0;
    }
    return drop_time(depth, velocity, gravity, drag);
}

double rise_time(double height, double speed, double gravity, double drag) {
    if (gravity == 0.0) {
        return glide_time(height, speed, drag);
    }
    if (height == 0.0) {
        return 0.0;
    }
    // Drag only lowers the apex. Divided, since a square may overflow.
    if (speed <= 2.0 * gravity * height / speed) {
        return infinity;
    }
    const double parabola =
        2.0 *
        (height /
         (speed + std::sqrt(std::max(0.0, 1.0 - 2.0 * gravity * height / speed / speed)) * speed));
    if (drag * parabola < negligible_decay) {
        return parabola;
    }
    const double apex = apex_time(speed, gravity, drag);
    const double way = -fly(-speed, gravity, drag, apex).offset;
    if (way <= height) {
        return infinity;
    }
    return halley(parabola, {0.0, apex}, speed, -gravity, drag, height);
}

}  // namespace hyrax
