// SPDX-License-Identifier: MIT
#include "physics/runge_kutta.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hyrax {
namespace {

// x, y, vx, vy.
using Vector = std::array<double, 4>;

constexpr std::size_t stages = 7;
constexpr double nodes[stages][stages - 1] = {
    {},
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
};
constexpr double error_weights[stages] = {
    71.0 / 57600, 0.0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40
};
constexpr double dense_weights[stages] = {
    -12715105075.0 / 11282082432.0,
    0.0,
    87487479700.0 / 32700410799.0,
    -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0,
    -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0,
};

// A contact is looked for in this many parts of a step.
constexpr int parts = 4;

struct Motion {
    const Law& law;
    const ForceField& forces;
    Mode mode;
    bool leans = false;

    Vector slope(const Vector& y) const {
        if (mode == Mode::ground) {
            return {y[2], 0.0, -law.ground_drag * y[2], 0.0};
        }
        const double vx = y[2] - forces.wind.x;
        const double vy = y[3] - forces.wind.y;
        const double drag = forces.quadratic_drag == 0.0
                                ? law.drag
                                : law.drag + forces.quadratic_drag * std::hypot(vx, vy);
        const double pull = law.gravity - drag * vy;
        return leans ? Vector{0.0, y[3], 0.0, pull} : Vector{y[2], y[3], -drag * vx, pull};
    }
};

// One step of the pair; value(t) is its dense output, of order 4.
class Step {
public:
    Step(const Motion& motion, const Vector& start, double length) : length_(length) {
        std::array<Vector, stages> k;
        k[0] = motion.slope(start);
        Vector end = start;
        for (std::size_t i = 1; i < stages; ++i) {
            end = start;
            for (std::size_t j = 0; j < i; ++j) {
                for (std::size_t n = 0; n < end.size(); ++n) {
                    end[n] += length * nodes[i][j] * k[j][n];
                }
            }
            k[i] = motion.slope(end);
        }
        for (std::size_t n = 0; n < start.size(); ++n) {
            const double change = end[n] - start[n];
            const double bend = length * k[0][n] - change;
            double last = 0.0;
            for (std::size_t i = 0; i < stages; ++i) {
                error_[n] += length * error_weights[i] * k[i][n];
                last += length * dense_weights[i] * k[i][n];
            }
            terms_[n] = {start[n], change, bend, change - length * k[stages - 1][n] - bend, last};
        }
        end_ = end;
    }

    double length() const { return length_; }
    const Vector& end() const { return end_; }

    // Below 1 for a step that keeps the tolerance.
    double error(const RungeKuttaSettings& settings) const {
        double sum = 0.0;
        for (std::size_t n = 0; n < end_.size(); ++n) {
            const double scale =
                settings.absolute_tolerance +
                settings.relative_tolerance * std::max(std::fabs(terms_[n][0]), std::fabs(end_[n]));
            sum += (error_[n] / scale) * (error_[n] / scale);
        }
        const double error = std::sqrt(sum / static_cast<double>(end_.size()));
        return std::isnan(error) ? infinity : error;
    }

    double value(std::size_t n, double t) const {
        if (t == length_) {
            return end_[n];
        }
        const auto& term = terms_[n];
        const double a = t / length_;
        const double b = 1.0 - a;
        return term[0] + a * (term[1] + b * (term[2] + a * (term[3] + b * term[4])));
    }
    Vector values(double t) const { return {value(0, t), value(1, t), value(2, t), value(3, t)}; }

private:
    double length_;
    Vector end_{};
    Vector error_{};
    std::array<std::array<double, 5>, 4> terms_{};
};

// The root of a function with a change of sign in [low, high], by the Illinois method.
template <typename Function>
double root(Function f, double low, double high) {
    double f_low = f(low);
    double f_high = f(high);
    int side = 0;
    for (int i = 0; i < 100 && high - low > 2e-16 * high; ++i) {
        double t = (f_low * high - f_high * low) / (f_low - f_high);
        if (!(t > low && t < high)) {
            t = low + 0.5 * (high - low);
        }
        const double value = f(t);
        if (value == 0.0) {
            return t;
        }
        if ((value > 0.0) == (f_high > 0.0)) {
            high = t;
            f_high = value;
            f_low *= side == 1 ? 0.5 : 1.0;
            side = 1;
        } else {
            low = t;
            f_low = value;
            f_high *= side == -1 ? 0.5 : 1.0;
            side = -1;
        }
    }
    return high;
}

// The first contact on the dense output of a step.
class ContactSearch {
public:
    ContactSearch(const Step& step, const Law& law, Mode mode)
        : step_(step), law_(law), mode_(mode) {}

    Contact first(const FreeSpace& space) {
        if (mode_ == Mode::ground) {
            const Vec2 place{step_.value(0, 0.0), step_.value(1, 0.0)};
            const Support walls = space.corridor(place);
            // A corner that was met exactly is no part of the floor, but what lies before it is.
            const double ahead =
                std::nextafter(place.x, step_.value(2, 0.0) > 0.0 ? infinity : -infinity);
            const Support floor =
                space.support({ahead, place.y}).value_or(Support{place.x, place.x});
            consider(0, walls.right, 1.0, ContactKind::right_wall, nullptr);
            consider(0, walls.left, -1.0, ContactKind::left_wall, nullptr);
            consider(0, floor.right, 1.0, ContactKind::edge, nullptr);
            consider(0, floor.left, -1.0, ContactKind::edge, nullptr);
            consider_stop();
            return best_;
        }
        for (const Obstacle& obstacle : space.obstacles()) {
            consider(0, obstacle.left, 1.0, ContactKind::right_wall, &obstacle);
            consider(0, obstacle.right, -1.0, ContactKind::left_wall, &obstacle);
            consider(1, obstacle.top, 1.0, ContactKind::floor, &obstacle);
            consider(1, obstacle.bottom, -1.0, ContactKind::ceiling, &obstacle);
        }
        for (const Barrier& ledge : space.ledges()) {
            const Obstacle side{ledge.low, ledge.at, ledge.high, ledge.at};
            consider(1, ledge.at, 1.0, ContactKind::floor, &side);
        }
        return best_;
    }

private:
    // `direction`: of the motion that meets the side.
    void consider(
        std::size_t axis, double side, double direction, ContactKind kind, const Obstacle* obstacle
    ) {
        if (!std::isfinite(side)) {
            return;
        }
        const auto gap = [&](double t) { return direction * (side - step_.value(axis, t)); };
        // The step may begin on the side: then the trivial root is divided out.
        const bool on_side = gap(0.0) == 0.0;
        const double start_speed = direction * step_.value(axis + 2, 0.0);
        if (on_side && start_speed > 0.0) {
            accept({0.0, kind, side}, axis, obstacle);
            return;
        }
        const auto measure = [&](double t) {
            return on_side ? (t == 0.0 ? -start_speed : gap(t) / t) : gap(t);
        };
        double low = 0.0;
        bool was_positive = measure(0.0) > 0.0;
        for (int part = 1; part <= parts; ++part) {
            const double high = part == parts ? step_.length() : step_.length() * part / parts;
            const bool is_positive = measure(high) > 0.0;
            if (was_positive && !is_positive) {
                accept({root(measure, low, high), kind, side}, axis, obstacle);
                return;
            }
            was_positive = is_positive;
            low = high;
        }
    }

    void accept(const Contact& contact, std::size_t axis, const Obstacle* obstacle) {
        if (contact.time >= best_.time) {
            return;
        }
        if (obstacle != nullptr) {
            const double along = step_.value(1 - axis, contact.time);
            const double low = axis == 0 ? obstacle->top : obstacle->left;
            const double high = axis == 0 ? obstacle->bottom : obstacle->right;
            const double speed = step_.value(3 - axis, contact.time);
            const bool inside = (along > low && along < high) || (along == low && speed > 0.0) ||
                                (along == high && speed < 0.0);
            if (!inside) {
                return;
            }
        }
        best_ = contact;
    }

    void consider_stop() {
        const auto excess = [&](double t) {
            return std::fabs(step_.value(2, t)) - law_.stop_speed;
        };
        if (excess(step_.length()) <= 0.0) {
            const double t = root(excess, 0.0, step_.length());
            accept({t, ContactKind::stop, 0.0}, 0, nullptr);
        }
    }

    const Step& step_;
    const Law& law_;
    Mode mode_;
    Contact best_;
};

double next_length(double length, double error) {
    const double factor = error == 0.0 ? 5.0 : 0.9 * std::pow(error, -0.2);
    return length * std::clamp(factor, 0.2, 5.0);
}

// Whether wind holds a flying body against a wall, where it would bounce without end.
bool leans(
    const BodyState& state, const Law& law, const ForceField& forces, const FreeSpace& space
) {
    if (state.mode != Mode::air || forces.wind.x == 0.0 ||
        std::fabs(state.velocity.x) > law.rest_speed) {
        return false;
    }
    const Support walls = space.corridor(state.position);
    return state.position.x == (forces.wind.x > 0.0 ? walls.right : walls.left);
}

BodyState at_rest(BodyState state) {
    state.velocity = {};
    state.mode = Mode::rest;
    return state;
}

}  // namespace

BodyState step_runge_kutta(
    BodyState state,
    const Law& law,
    const ForceField& forces,
    const FreeSpace& space,
    const RungeKuttaSettings& settings,
    double dt,
    double& step,
    std::vector<Impact>& impacts
) {
    for (int trials = 0; dt > 0.0 && state.mode != Mode::rest; ++trials) {
        if (trials == settings.most_trials) {
            return at_rest(state);
        }
        const Motion motion{law, forces, state.mode, leans(state, law, forces, space)};
        if (motion.leans) {
            state.velocity.x = 0.0;
        }
        const double length = std::min(step, dt);
        const Step trial(
            motion, {state.position.x, state.position.y, state.velocity.x, state.velocity.y}, length
        );
        const double error = trial.error(settings);
        if (error > 1.0) {
            step = next_length(length, error);
            continue;
        }
        // The last piece of a frame says little about the length that the next one bears.
        if (length == step || next_length(length, error) > step) {
            step = next_length(length, error);
        }
        const Contact contact = ContactSearch(trial, law, state.mode).first(space);
        const double t = std::min(contact.time, length);
        const Vector values = trial.values(t);
        state.position = {values[0], values[1]};
        state.velocity = {values[2], values[3]};
        if (contact.kind != ContactKind::none) {
            const bool is_wall =
                contact.kind == ContactKind::left_wall || contact.kind == ContactKind::right_wall;
            impacts.push_back({contact, std::fabs(is_wall ? values[2] : values[3])});
            state = after_contact(contact, state, law, space);
            state.position = space.nearest(state.position);
        }
        dt -= t;
    }
    const double speed = std::hypot(state.velocity.x, state.velocity.y);
    const bool drifts =
        law.gravity == 0.0 && law.drag > 0.0 && forces.wind == Vec2{} && speed <= law.stop_speed;
    return drifts ? at_rest(state) : state;
}

}  // namespace hyrax
