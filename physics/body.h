// SPDX-License-Identifier: MIT
// A body moved by the integrator that its rules name.
#pragma once

#include "physics/document_body.h"
#include "physics/runge_kutta.h"
#include "physics/trajectory.h"

#include <cstdint>
#include <variant>

namespace hyrax {

enum class Integrator : std::uint8_t {
    event_driven,               ///< Piecewise closed form, read lazily. Exact at any frame rate.
    semi_implicit_euler,        ///< The document's law, once for each frame.
    semi_implicit_euler_fixed,  ///< Rates instead of multipliers, fixed steps, interpolated.
    exponential_swept,          ///< Exact flight from frame to frame, impacts located.
    stormer_verlet,             ///< Strang splitting, impacts located.
    rk45,                       ///< Dormand-Prince with dense output: for forces of any form.
};

/// How all bodies of a scene move.
struct MotionRules {
    Integrator integrator = Integrator::event_driven;
    PhysicsConstants constants;
    Law law = law_from({});           ///< Of the same constants.
    double fixed_step = 1.0 / 240.0;  ///< Of semi_implicit_euler_fixed [s], positive.
    ForceField forces{};              ///< Felt by rk45 alone.
    bool operator==(const MotionRules&) const = default;
};

/// What a body moves among.
struct Surroundings {
    const FreeSpace& space;  ///< For the body's size.
    Rect home;               ///< The room that the document's law keeps it in.
    Size size;
};

/// Between launch() and the next launch(), rules and surroundings must stay the same.
class Body {
public:
    /// Begins to move at the next start(). Finite numbers only; a place outside becomes the nearest
    /// one inside. Positions are top-left corners in the coordinates of the space [px].
    void launch(
        Vec2 position,
        Vec2 velocity,
        const MotionRules& rules,
        const Surroundings& around,
        WallEvents walls
    );
    /// The moment at which the motion begins.
    void start(Ticks now);

    /// Moves on to `now`, not before start(), and tells each contact to `sink(TrajectoryEvent)`.
    template <typename Sink>
    void advance(Ticks now, const MotionRules& rules, const Surroundings& around, Sink sink) {
        if (auto* const trajectory = std::get_if<Trajectory>(&motion_)) {
            trajectory->advance(now, rules.law, around.space, sink);
            return;
        }
        events_.clear();
        step(now, rules, around);
        for (const TrajectoryEvent& event : events_) {
            sink(event);
        }
    }

    /// The state at `now`, from the last start() or advance() on.
    BodyState at(Ticks now, const MotionRules& rules, const Surroundings& around) const;
    Mode mode() const;
    /// True while walls are not followed one by one: of event_driven alone.
    bool is_folded() const;
    /// When something will have happened; for all but event_driven, at once while it moves.
    Ticks next_event() const;

private:
    // For integrators that go from frame to frame.
    struct Stepped {
        BodyState state;
        BodyState before;  // One fixed step earlier.
        Ticks time = 0;
        double trial_step = 1.0 / 60.0;  // Of rk45 [s].
    };

    void step(Ticks now, const MotionRules& rules, const Surroundings& around);
    void step_fixed(Stepped& body, Ticks now, const MotionRules& rules, const FreeSpace& space);
    void collect(Ticks time);

    std::variant<Trajectory, DocumentBody, Stepped> motion_;
    std::vector<TrajectoryEvent> events_;
    std::vector<Impact> impacts_;
};

}  // namespace hyrax
