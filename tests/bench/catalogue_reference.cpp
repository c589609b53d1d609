// SPDX-License-Identifier: MIT
#include "tests/bench/catalogue_reference.h"

#include <limits>

namespace hyrax::bench {
namespace {

using Real = long double;

constexpr Real endless = std::numeric_limits<Real>::infinity();

// The time that the way of a body without forces takes, with drag measured as time: dx/ds is
// constant for s = (1 - exp(-k t)) / k.
Real shortened(Real drag, Real t) {
    return drag == 0.0L ? t : -std::expm1(-drag * t) / drag;
}

Real lengthened(Real drag, Real s) {
    if (drag == 0.0L) {
        return s;
    }
    return drag * s >= 1.0L ? endless : -std::log1p(-drag * s) / drag;
}

struct Real2 {
    Real x = 0.0L;
    Real y = 0.0L;
};

class Reference {
public:
    explicit Reference(const Scene& scene)
        : gravity_(scene.law.gravity),
          drag_(scene.law.drag),
          law_(scene.law),
          bounds_(scene.bounds),
          at_{scene.position.x, scene.position.y},
          v_{scene.velocity.x, scene.velocity.y} {
        on_floor_ = gravity_ > 0.0L && at_.y == bounds_.bottom && v_.y == 0.0L;
        stop_if_slow();
    }

    void advance(Real t) {
        while (!at_rest_) {
            const Real wall = wall_time();
            const Real floor = on_floor_ ? stop_time() : floor_time();
            const Real ceiling = on_floor_ ? endless : ceiling_time();
            const Real first = std::min(wall, std::min(floor, ceiling));
            if (first > t) {
                move(t);
                return;
            }
            move(first);
            t -= first;
            if (first == wall) {
                at_.x = v_.x > 0.0L ? bounds_.right : bounds_.left;
                v_.x *= -static_cast<Real>(law_.restitution);
                stop_if_slow();
            } else if (first == ceiling) {
                at_.y = bounds_.top;
                v_.y *= -static_cast<Real>(law_.restitution);
            } else {
                meet_floor();
            }
        }
    }

    BodyState state() const {
        return {
            {static_cast<double>(at_.x), static_cast<double>(at_.y)},
            {static_cast<double>(v_.x), static_cast<double>(v_.y)},
            at_rest_ ? Mode::rest : (on_floor_ ? Mode::ground : Mode::air)
        };
    }

private:
    Real drag_now() const { return on_floor_ ? static_cast<Real>(law_.ground_drag) : drag_; }

    Real fall(Real t) const {
        if (drag_ == 0.0L) {
            return t * (v_.y + 0.5L * gravity_ * t);
        }
        const Real s = shortened(drag_, t);
        return v_.y * s + gravity_ * (t - s) / drag_;
    }

    void move(Real t) {
        const Real s = shortened(drag_now(), t);
        at_.x += v_.x * s;
        v_.x *= std::exp(-drag_now() * t);
        if (!on_floor_) {
            at_.y += fall(t);
            v_.y = v_.y * std::exp(-drag_ * t) + gravity_ * shortened(drag_, t);
        }
    }

    Real wall_time() const {
        if (v_.x == 0.0L) {
            return endless;
        }
        const Real way = v_.x > 0.0L ? bounds_.right - at_.x : at_.x - bounds_.left;
        return lengthened(drag_now(), way / std::fabs(v_.x));
    }

    Real apex_time() const {
        if (v_.y >= 0.0L) {
            return 0.0L;
        }
        const Real ratio = -v_.y / gravity_;
        return drag_ == 0.0L ? ratio : std::log1p(drag_ * ratio) / drag_;
    }

    // Where the height passes `side`, which it does once between the two times.
    Real crossing(Real low, Real high, Real side, Real direction) const {
        for (int i = 0; i < 100 && low < high; ++i) {
            const Real middle = 0.5L * (low + high);
            (direction * (at_.y + fall(middle) - side) < 0.0L ? low : high) = middle;
        }
        return high;
    }

    Real floor_time() const {
        if (gravity_ == 0.0L || std::isinf(bounds_.bottom)) {
            return endless;
        }
        const Real low = apex_time();
        Real high = low + 1e-6L;
        while (at_.y + fall(high) < bounds_.bottom) {
            high *= 2.0L;
        }
        return crossing(low, high, bounds_.bottom, 1.0L);
    }

    Real ceiling_time() const {
        if (v_.y >= 0.0L || gravity_ == 0.0L || std::isinf(bounds_.top)) {
            return endless;
        }
        const Real apex = apex_time();
        return at_.y + fall(apex) > bounds_.top ? endless
                                                : crossing(0.0L, apex, bounds_.top, -1.0L);
    }

    Real stop_time() const {
        const Real ratio = std::fabs(v_.x) / static_cast<Real>(law_.stop_speed);
        return drag_now() == 0.0L ? endless : std::log(ratio) / drag_now();
    }

    void meet_floor() {
        if (on_floor_) {
            v_.x = 0.0L;
            at_rest_ = true;
            return;
        }
        at_.y = bounds_.bottom;
        v_.x *= static_cast<Real>(law_.impact_friction);
        v_.y *= -static_cast<Real>(law_.restitution);
        if (-v_.y < static_cast<Real>(law_.rest_speed)) {
            v_.y = 0.0L;
            on_floor_ = true;
            stop_if_slow();
        }
    }

    void stop_if_slow() {
        if (on_floor_ && std::fabs(v_.x) <= static_cast<Real>(law_.stop_speed)) {
            v_.x = 0.0L;
            at_rest_ = true;
        }
    }

    Real gravity_;
    Real drag_;
    Law law_;
    Bounds bounds_;
    Real2 at_;
    Real2 v_;
    bool on_floor_ = false;
    bool at_rest_ = false;
};

}  // namespace

BodyState reference(const Scene& scene, double seconds) {
    Reference body(scene);
    body.advance(seconds);
    return body.state();
}

}  // namespace hyrax::bench
