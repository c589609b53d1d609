// SPDX-License-Identifier: MIT
#include "physics/spring.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hyrax {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr SpringMatrix at_target{0.0, 0.0, 0.0, 0.0};

bool is_spring(const SpringConstants& constants) {
    return constants.frequency >= 0.0 && constants.frequency < infinity &&
           constants.damping_ratio >= 0.0 && constants.damping_ratio < infinity;
}

// No branch for damping ratios near 1: sin(x)/x is accurate down to 0.
SpringMatrix underdamped(double w, double zeta, double t) {
    const double envelope = std::exp(-zeta * w * t);
    const double phase = w * std::sqrt((1.0 - zeta) * (1.0 + zeta)) * t;
    if (!std::isfinite(phase)) {
        return at_target;
    }
    const double c = envelope * std::cos(phase);
    const double s = envelope * t * (phase > 0.0 ? std::sin(phase) / phase : 1.0);
    // (w s) w and not w^2 s: w^2 overflows first.
    return {c + zeta * w * s, s, -(w * s) * w, c - zeta * w * s};
}

// The slow rate is w^2 / fast, and neither diagonal element subtracts near-equal numbers:
// zeta w - r and e^(-slow t) - slow s would cancel.
SpringMatrix overdamped(double w, double zeta, double t) {
    const double root = w * std::sqrt(zeta - 1.0) * std::sqrt(zeta + 1.0);
    const double fast = zeta * w + root;
    const double slow = w / fast * w;
    const double slow_decay = std::exp(-slow * t);
    const double fast_decay = std::exp(-fast * t);
    const double gap = 2.0 * root * t;
    const double s = slow_decay * (gap > 0.0 ? -std::expm1(-gap) / (2.0 * root) : t);
    return {slow_decay + slow * s, s, -(w * s) * w, fast_decay - slow * s};
}

double seconds_between(Ticks from, Ticks to) {
    return to_seconds(span_between(from, to));
}

Ticks later(Ticks time, Ticks span) {
    return time > never - span ? never : time + span;
}

bool acceptable(Vec2 v) {
    // False for NaN as well.
    return std::fabs(v.x) <= Spring::max_input && std::fabs(v.y) <= Spring::max_input;
}

}  // namespace

SpringMatrix propagator(const SpringConstants& constants, double seconds) {
    const auto [w, zeta] = constants;
    if (!is_spring(constants) || seconds == infinity) {
        return at_target;
    }
    if (!(seconds > 0.0)) {
        return {};
    }
    if (w == 0.0) {
        return {1.0, seconds, 0.0, 1.0};
    }
    return zeta < 1.0 ? underdamped(w, zeta, seconds) : overdamped(w, zeta, seconds);
}

Spring::Spring(const SpringConstants& constants) : constants_(constants) {
    if (!is_spring(constants) || constants.frequency > max_frequency) {
        constants_.frequency = infinity;
    }
}

bool Spring::grab(const SpringBody& body, Vec2 target, Ticks time) {
    if (!acceptable(body.position) || !acceptable(body.velocity) || !acceptable(target)) {
        return false;
    }
    hold_ = {time, target, {}, body.position - target, body.velocity};
    glide_ = hold_;
    intervals_ = {};
    passed_ = 0;
    return true;
}

Spring::Leg Spring::moved(const Leg& leg, const SpringMatrix& matrix, Ticks to) {
    return {
        std::max(leg.start, to),
        leg.target + leg.slope * seconds_between(leg.start, to),
        leg.slope,
        leg.offset * matrix.a11 + leg.rate * matrix.a12,
        leg.offset * matrix.a21 + leg.rate * matrix.a22
    };
}

const SpringMatrix& Spring::sample_matrix(Ticks from, Ticks to) {
    if (const Ticks span = span_between(from, to); span != span_) {
        span_ = span;
        matrix_ = propagator(constants_, seconds_between(from, to));
    }
    return matrix_;
}

// Where the cursor goes next is unknown: the target glides to each sample in the time that samples
// take to come, late by one interval of the mouse and never by more than max_glide. Holding steps
// at each sample, and lags by 2 zeta / w; extrapolating runs past each stop. The longer of two
// intervals because the clocks of mice jitter: it keeps the target from stopping short.
bool Spring::follow(Vec2 target, Ticks time) {
    if (!acceptable(target) || time < glide_.start) {
        return false;
    }
    if (const Ticks silence = span_between(glide_.start, time); silence <= longest_interval) {
        intervals_ = {silence, intervals_[0]};
    }
    const Ticks interval = std::clamp(longer_interval(), min_glide, max_glide);
    const Leg& old = leg_at(time);
    const Leg before = old.start == time ? old : moved(old, sample_matrix(old.start, time), time);
    // Of two samples in quick succession, the second must not outrun the first.
    const Ticks arrival = std::max(hold_.start, later(time, interval));

    past_[passed_ % past_.size()] = {glide_, hold_};
    ++passed_;
    glide_ = before;
    const double duration = seconds_between(time, arrival);
    glide_.slope = duration > 0.0 ? (target - before.target) * (1.0 / duration) : Vec2{};
    glide_.rate = before.rate + before.slope - glide_.slope;
    hold_ = moved(glide_, sample_matrix(time, arrival), arrival);
    hold_.target = target;
    hold_.rate = hold_.rate + hold_.slope;
    hold_.slope = {};
    return true;
}

SpringBody Spring::at(Ticks time) const {
    return on(leg_at(time), time);
}

Vec2 Spring::target(Ticks time) const {
    const Leg& leg = leg_at(time);
    return leg.target + leg.slope * seconds_between(leg.start, time);
}

SpringBody Spring::on(const Leg& leg, Ticks time) const {
    const Leg now = moved(leg, propagator(constants_, seconds_between(leg.start, time)), time);
    return {now.target + now.offset, now.slope + now.rate};
}

// Exact as at() is, but as far back as past_ goes.
Vec2 Spring::place(Ticks time) const {
    if (time >= glide_.start) {
        return at(time).position;
    }
    std::size_t age = 1;
    while (age < remembered() && past(age).glide.start > time) {
        ++age;
    }
    const Segment& then = past(age);
    return on(time < then.hold.start ? then.glide : then.hold, time).position;
}

// Under a pointer that is heard of seldom the target goes by jerks, and the body after it: only
// over a whole interval its mean velocity is the hand's.
Vec2 Spring::mean_velocity(Ticks time) const {
    const Ticks window = std::max(longer_interval(), shortest_window);
    const Ticks first = passed_ > 0 ? past(remembered()).glide.start : glide_.start;
    const Ticks start = span_between(first, time) > window ? time - window : first;
    const SpringBody now = at(time);
    const double span = seconds_between(start, time);
    return span > 0.0 ? (now.position - place(start)) * (1.0 / span) : now.velocity;
}

Vec2 Spring::release_velocity(Ticks time, double max_speed) const {
    Vec2 velocity = mean_velocity(time);
    if (time >= hold_.start) {
        velocity.x = velocity.x * glide_.slope.x < 0.0 ? 0.0 : velocity.x;
        velocity.y = velocity.y * glide_.slope.y < 0.0 ? 0.0 : velocity.y;
    }
    const double speed = std::hypot(velocity.x, velocity.y);
    if (!(max_speed > 0.0)) {
        return {};
    }
    return speed > max_speed ? velocity * (max_speed / speed) : velocity;
}

}  // namespace hyrax
