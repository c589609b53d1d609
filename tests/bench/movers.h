// SPDX-License-Identifier: MIT
// One body under each integrator, all with the same calls.
#pragma once

#include "physics/body.h"
#include "physics/steppers.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hyrax::bench {

/// Where a body starts and what moves it.
struct BodyScene {
    std::string name;
    PhysicsConstants constants;  ///< For the document's law; `law` says the same in rates.
    Law law;
    FreeSpace space;
    Size room;  ///< For the document's law: from 0 to here its top-left corner may be [px].
    Vec2 at;
    Vec2 velocity;
};

/// A box from the origin to the far corner, without the size of the body [px].
BodyScene box_scene(const PhysicsConstants& constants, Size room, Vec2 at, Vec2 velocity);

enum class Method {
    document,             ///< class physics, frame by frame.
    semi_implicit_euler,  ///< The same with rates in place of multipliers and with rest.
    stormer_verlet,
    rk45,
    exponential_swept,
    event_driven
};

struct NamedMethod {
    Method method;
    std::string_view name;
};

inline constexpr std::array<NamedMethod, 6> methods{{
    {Method::document, "document"},
    {Method::semi_implicit_euler, "semi_implicit_euler"},
    {Method::stormer_verlet, "stormer_verlet"},
    {Method::rk45, "rk45"},
    {Method::exponential_swept, "exponential_swept"},
    {Method::event_driven, "event_driven"},
}};

std::string_view name_of(Method method);
std::optional<Method> method_named(std::string_view name);

/// Each mover's go_to() moves on to `now`, `dt` [s] after the last call, and returns the position.
class DocumentMover {
public:
    explicit DocumentMover(const BodyScene& scene);
    Vec2 go_to(Ticks, double dt) {
        body_.update(dt, room_.width, room_.height, 0, 0);
        return {body_.x(), body_.y()};
    }
    BodyState state() const { return {{body_.x(), body_.y()}, {body_.vx(), body_.vy()}}; }

private:
    physics body_;
    Size room_;
};

template <auto step>
class SteppingMover {
public:
    explicit SteppingMover(const BodyScene& scene)
        : scene_(&scene), state_(let_go(scene.at, scene.velocity, scene.law, scene.space)) {}
    Vec2 go_to(Ticks, double dt) {
        impacts_.clear();
        state_ = step(state_, scene_->law, scene_->space, dt, impacts_);
        return state_.position;
    }
    BodyState state() const { return state_; }

private:
    const BodyScene* scene_;
    BodyState state_;
    std::vector<Impact> impacts_;
};

class RungeKuttaMover {
public:
    RungeKuttaMover(const BodyScene& scene, double tolerance)
        : scene_(&scene),
          settings_{.relative_tolerance = tolerance, .absolute_tolerance = tolerance},
          state_(let_go(scene.at, scene.velocity, scene.law, scene.space)) {}
    Vec2 go_to(Ticks, double dt) {
        impacts_.clear();
        state_ = step_runge_kutta(
            state_, scene_->law, {}, scene_->space, settings_, dt, trial_step_, impacts_
        );
        return state_.position;
    }
    BodyState state() const { return state_; }

private:
    const BodyScene* scene_;
    RungeKuttaSettings settings_;
    BodyState state_;
    double trial_step_ = 1.0 / 60.0;
    std::vector<Impact> impacts_;
};

class EventMover {
public:
    explicit EventMover(const BodyScene& scene) : scene_(&scene) {
        trajectory_.launch(0, scene.at, scene.velocity, scene.law, scene.space);
    }
    Vec2 go_to(Ticks now, double) {
        now_ = now;
        trajectory_.advance(now, scene_->law, scene_->space, [](const TrajectoryEvent&) {});
        return trajectory_.position(now, scene_->law, scene_->space);
    }
    BodyState state() const { return trajectory_.at(now_, scene_->law, scene_->space); }

private:
    const BodyScene* scene_;
    Trajectory trajectory_;
    Ticks now_ = 0;
};

/// Calls `use` with a mover that has just been launched. The scene must outlive it.
template <typename Use>
decltype(auto) with_mover(Method method, const BodyScene& scene, double tolerance, Use use) {
    switch (method) {
        case Method::document:
            return use(DocumentMover(scene));
        case Method::semi_implicit_euler:
            return use(SteppingMover<step_semi_implicit_euler>(scene));
        case Method::stormer_verlet:
            return use(SteppingMover<step_stormer_verlet>(scene));
        case Method::rk45:
            return use(RungeKuttaMover(scene, tolerance));
        case Method::exponential_swept:
            return use(SteppingMover<step_exponential_swept>(scene));
        case Method::event_driven:
            break;
    }
    return use(EventMover(scene));
}

}  // namespace hyrax::bench
