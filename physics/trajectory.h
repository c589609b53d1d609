// SPDX-License-Identifier: MIT
// The event-driven integrator: a body as a piecewise closed-form trajectory, which is read where
// it is needed. Its shape depends on how it was launched alone, never on when it is read.
#pragma once

#include "physics/contact.h"
#include "physics/ticks.h"

#include <algorithm>

namespace hyrax {

/// A contact that has happened.
struct TrajectoryEvent {
    Ticks time = 0;
    ContactKind kind = ContactKind::none;
    double speed = 0.0;  ///< Towards the side at the impact [px/s].
};

/// Whether somebody wants to hear of every wall. If not, a body that is too quick for its box to
/// be followed bounce by bounce is folded into it at once.
enum class WallEvents : std::uint8_t { wanted, not_wanted };

/// One law and one space rule a trajectory from launch to launch: pass the same ones to every call.
class Trajectory {
public:
    /// More events than this in one advance() end the motion: what remains to be done is folded
    /// between the walls and put on the floor.
    static constexpr int most_events = 4096;

    /// At rest at the origin.
    Trajectory() = default;

    /// A new trajectory from a finite position [px] and velocity [px/s]. A place outside the space
    /// becomes the nearest one in it.
    void launch(
        Ticks now,
        Vec2 position,
        Vec2 velocity,
        const Law& law,
        const FreeSpace& space,
        WallEvents walls = WallEvents::wanted
    );

    /// Moves the whole trajectory in time, so that it begins at `now`. Before its first event only.
    void start(Ticks now) {
        due_ += due_ == never ? 0 : now - since_;
        since_ = now;
    }

    /// Passes all events up to and including `now`, and tells each to `sink(TrajectoryEvent)`.
    template <typename Sink>
    void advance(Ticks now, const Law& law, const FreeSpace& space, Sink sink) {
        for (int events = 0; due_ <= now; ++events) {
            if (events == most_events) {
                give_up(now, law, space);
                return;
            }
            sink(pass_event(law, space));
        }
    }

    /// The state at `now`, from the last event to the next one.
    BodyState at(Ticks now, const Law& law, const FreeSpace& space) const {
        const double t = elapsed(now);
        BodyState state = folded_ ? folded(t, law, space) : free_motion(start_, law, t);
        state.position = bounds_.clamp(state.position);
        return state;
    }
    /// Its position alone, which costs less.
    Vec2 position(Ticks now, const Law& law, const FreeSpace& space) const {
        return at(now, law, space).position;
    }
    Mode mode() const { return start_.mode; }
    /// True while walls are not followed one by one.
    bool is_folded() const { return folded_; }
    /// The first moment at which the next event is past; `never` for a motion without one.
    Ticks next_event() const { return due_; }

private:
    // The time of a contact is rounded: what is read just before it must not lie beyond its side.
    struct Bounds {
        Vec2 low{-infinity, -infinity};
        Vec2 high{infinity, infinity};
        Vec2 clamp(Vec2 p) const {
            return {std::min(std::max(p.x, low.x), high.x), std::min(std::max(p.y, low.y), high.y)};
        }
    };

    double elapsed(Ticks now) const { return to_seconds(now - since_) - fraction_; }
    TrajectoryEvent pass_event(const Law& law, const FreeSpace& space);
    void give_up(Ticks now, const Law& law, const FreeSpace& space);
    void schedule(const Law& law, const FreeSpace& space);
    BodyState folded(double t, const Law& law, const FreeSpace& space) const;

    BodyState start_{{}, {}, Mode::rest};
    Ticks since_ = 0;  // The moment of start_ is since_ + fraction_ [s]: events fall between ticks.
    double fraction_ = 0.0;
    Contact next_;  // Its time counts from start_.
    Ticks due_ = never;
    Bounds bounds_;
    WallEvents walls_ = WallEvents::wanted;
    bool folded_ = false;
};

}  // namespace hyrax
