// SPDX-License-Identifier: MIT
#include "physics/body.h"

#include <algorithm>
#include <cmath>

namespace hyrax {
namespace {

BodyState stepped(
    const BodyState& state,
    const MotionRules& rules,
    const FreeSpace& space,
    double dt,
    double& trial_step,
    std::vector<Impact>& impacts
) {
    switch (rules.integrator) {
        case Integrator::exponential_swept:
            return step_exponential_swept(state, rules.law, space, dt, impacts);
        case Integrator::stormer_verlet:
            return step_stormer_verlet(state, rules.law, space, dt, impacts);
        case Integrator::rk45:
            return step_runge_kutta(
                state, rules.law, rules.forces, space, {}, dt, trial_step, impacts
            );
        case Integrator::semi_implicit_euler_fixed:
        case Integrator::semi_implicit_euler:
        case Integrator::event_driven:
            break;
    }
    return step_semi_implicit_euler(state, rules.law, space, dt, impacts);
}

}  // namespace

void Body::launch(
    Vec2 position,
    Vec2 velocity,
    const MotionRules& rules,
    const Surroundings& around,
    WallEvents walls
) {
    switch (rules.integrator) {
        case Integrator::event_driven: {
            Trajectory trajectory;
            trajectory.launch(
                0, position + around.space.overhang(), velocity, rules.law, around.space, walls
            );
            motion_ = trajectory;
            return;
        }
        case Integrator::semi_implicit_euler:
            motion_ = DocumentBody(position, velocity, rules.constants, around.home, around.size);
            return;
        default: {
            const BodyState state =
                let_go(position + around.space.overhang(), velocity, rules.law, around.space);
            motion_ = Stepped{.state = state, .before = state};
            return;
        }
    }
}

void Body::start(Ticks now) {
    if (auto* const trajectory = std::get_if<Trajectory>(&motion_)) {
        trajectory->start(now);
    } else if (auto* const document = std::get_if<DocumentBody>(&motion_)) {
        document->start(now);
    } else {
        std::get<Stepped>(motion_).time = now;
    }
}

void Body::step(Ticks now, const MotionRules& rules, const Surroundings& around) {
    if (auto* const document = std::get_if<DocumentBody>(&motion_)) {
        document->advance(now, events_);
        return;
    }
    Stepped& body = std::get<Stepped>(motion_);
    if (rules.integrator == Integrator::semi_implicit_euler_fixed) {
        step_fixed(body, now, rules, around.space);
        return;
    }
    const double dt = to_seconds(now - body.time);
    body.time = now;
    if (dt > 0.0) {
        body.state = stepped(body.state, rules, around.space, dt, body.trial_step, impacts_);
        collect(now);
    }
}

// The classic accumulator: whole steps only, and the picture between the last two.
void Body::step_fixed(Stepped& body, Ticks now, const MotionRules& rules, const FreeSpace& space) {
    const Ticks step = from_seconds(rules.fixed_step);
    while (body.time + step <= now) {
        body.time += step;
        body.before = body.state;
        body.state = stepped(body.state, rules, space, rules.fixed_step, body.trial_step, impacts_);
        collect(body.time);
        if (body.state.mode == Mode::rest && body.before == body.state) {
            body.time = now;
        }
    }
}

void Body::collect(Ticks time) {
    for (const Impact& impact : impacts_) {
        events_.push_back({time, impact.contact.kind, impact.speed});
    }
    impacts_.clear();
}

BodyState Body::at(Ticks now, const MotionRules& rules, const Surroundings& around) const {
    BodyState state;
    if (const auto* const trajectory = std::get_if<Trajectory>(&motion_)) {
        state = trajectory->at(now, rules.law, around.space);
    } else if (const auto* const document = std::get_if<DocumentBody>(&motion_)) {
        return {document->position(), document->velocity(), document->mode()};
    } else {
        const Stepped& body = std::get<Stepped>(motion_);
        state = body.state;
        const bool between_steps = state.mode != Mode::rest;
        if (rules.integrator == Integrator::semi_implicit_euler_fixed && between_steps) {
            const double share = to_seconds(now - body.time) / rules.fixed_step;
            state.position =
                body.before.position + (body.state.position - body.before.position) * share;
        }
    }
    state.position = state.position - around.space.overhang();
    return state;
}

Mode Body::mode() const {
    if (const auto* const trajectory = std::get_if<Trajectory>(&motion_)) {
        return trajectory->mode();
    }
    if (const auto* const document = std::get_if<DocumentBody>(&motion_)) {
        return document->mode();
    }
    return std::get<Stepped>(motion_).state.mode;
}

bool Body::is_folded() const {
    const auto* const trajectory = std::get_if<Trajectory>(&motion_);
    return trajectory != nullptr && trajectory->is_folded();
}

Ticks Body::next_event() const {
    if (const auto* const trajectory = std::get_if<Trajectory>(&motion_)) {
        return trajectory->next_event();
    }
    return mode() == Mode::rest ? never : 0;
}

}  // namespace hyrax
