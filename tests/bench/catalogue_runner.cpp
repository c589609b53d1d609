// SPDX-License-Identifier: MIT
#include "tests/bench/catalogue_runner.h"

#include "physics/physics.h"
#include "physics/steppers.h"

#include <vector>

namespace hyrax::bench {
namespace {

FreeSpace space_of(const Bounds& bounds) {
    if (std::isinf(bounds.bottom)) {
        return {};
    }
    return FreeSpace::box(bounds.left, bounds.top, bounds.right, bounds.bottom);
}

// The class knows one room with its corner at the origin, in whole pixels. Without walls the room
// follows the body, which is put back into its middle after each frame.
class DocumentRunner final : public Runner {
public:
    explicit DocumentRunner(const Scene& scene) {
        confine(scene.bounds);
        const Vec2 origin = is_open_ ? scene.position - middle : corner_;
        corner_ = origin;
        const Vec2 at = scene.position - origin;
        body_ = physics(at.x, at.y, scene.velocity.x, scene.velocity.y);
        body_.setConstants(scene.constants);
    }

    void advance(Ticks span) override {
        body_.update(to_seconds(span), width_, height_, 0, 0);
        ++work_;
        if (is_open_) {
            corner_ = corner_ + (Vec2{body_.x(), body_.y()} - middle);
            body_.setPos(middle.x, middle.y);
        }
    }

    BodyState state() const override {
        return {corner_ + Vec2{body_.x(), body_.y()}, {body_.vx(), body_.vy()}, Mode::air};
    }

    void confine(const Bounds& bounds) override {
        is_open_ = std::isinf(bounds.bottom);
        width_ = is_open_ ? room : static_cast<int>(bounds.width());
        height_ = is_open_ ? room : static_cast<int>(bounds.bottom - bounds.top);
        corner_ = {bounds.left, bounds.top};
    }

    long long work() const override { return work_; }

private:
    static constexpr int room = 1 << 21;
    static constexpr Vec2 middle{room / 2.0, room / 2.0};

    physics body_;
    Vec2 corner_;
    int width_ = 0;
    int height_ = 0;
    bool is_open_ = false;
    long long work_ = 0;
};

class StepRunner final : public Runner {
public:
    StepRunner(Column column, const Scene& scene)
        : column_(column),
          scene_(scene),
          space_(space_of(scene.bounds)),
          state_(let_go(scene.position, scene.velocity, scene.law, space_)) {}

    void advance(Ticks span) override {
        step(to_seconds(span));
        // An impact ends a trial step of Runge and Kutta, with its six new evaluations.
        const long long evaluations = column_ == Column::rk45 ? 6 : 1;
        work_ += evaluations * (1 + static_cast<long long>(impacts_.size()));
        impacts_.clear();
    }

    BodyState state() const override { return state_; }

    void confine(const Bounds& bounds) override {
        space_ = space_of(bounds);
        state_ = let_go(state_.position, state_.velocity, scene_.law, space_);
    }

    long long work() const override { return work_; }

private:
    void step(double dt) {
        const Law& law = scene_.law;
        if (column_ == Column::semi_implicit_euler) {
            state_ = step_semi_implicit_euler(state_, law, space_, dt, impacts_);
        } else if (column_ == Column::stormer_verlet) {
            state_ = step_stormer_verlet(state_, law, space_, dt, impacts_);
        } else if (column_ == Column::exponential_swept) {
            state_ = step_exponential_swept(state_, law, space_, dt, impacts_);
        } else {
            state_ = step_runge_kutta(
                state_, law, {}, space_, scene_.tolerances, dt, trial_step_, impacts_
            );
        }
    }

    Column column_;
    Scene scene_;
    FreeSpace space_;
    BodyState state_;
    double trial_step_ = 1.0 / 60.0;
    std::vector<Impact> impacts_;
    long long work_ = 0;
};

class ExactRunner final : public Runner {
public:
    explicit ExactRunner(const Scene& scene)
        : scene_(scene), space_(space_of(scene.bounds)), now_(scene.start) {
        relaunch(scene.position, scene.velocity);
    }

    void advance(Ticks span) override {
        now_ += span;
        trajectory_.advance(now_, scene_.law, space_, [this](const TrajectoryEvent&) { ++work_; });
    }

    BodyState state() const override { return trajectory_.at(now_, scene_.law, space_); }

    void confine(const Bounds& bounds) override {
        const BodyState before = state();
        space_ = space_of(bounds);
        relaunch(before.position, before.velocity);
    }

    long long work() const override { return work_; }

private:
    void relaunch(Vec2 position, Vec2 velocity) {
        trajectory_.launch(now_, position, velocity, scene_.law, space_, WallEvents::not_wanted);
    }

    Scene scene_;
    FreeSpace space_;
    Ticks now_;
    Trajectory trajectory_;
    long long work_ = 0;
};

}  // namespace

std::unique_ptr<Runner> launch(Column column, const Scene& scene) {
    switch (column) {
        case Column::document:
            return std::make_unique<DocumentRunner>(scene);
        case Column::exact:
            return std::make_unique<ExactRunner>(scene);
        case Column::semi_implicit_euler:
        case Column::stormer_verlet:
        case Column::rk45:
        case Column::exponential_swept:
            break;
    }
    return std::make_unique<StepRunner>(column, scene);
}

BodyState state_after(Column column, const Scene& scene, double seconds, double rate) {
    return run(*launch(column, scene), seconds, rate);
}

}  // namespace hyrax::bench
