// SPDX-License-Identifier: MIT
// What a body meets next, and what the meeting makes of it.
#pragma once

#include "physics/flight.h"
#include "physics/free_space.h"
#include "physics/law.h"

#include <cstdint>

namespace hyrax {

/// What rules the motion.
enum class Mode : std::uint8_t {
    air,     ///< Gravity and drag.
    ground,  ///< Sliding on a floor.
    rest,    ///< Nothing moves.
};

struct BodyState {
    Vec2 position;  ///< [px]
    Vec2 velocity;  ///< [px/s]
    Mode mode = Mode::air;
    bool operator==(const BodyState&) const = default;
};

/// What ends a stretch of closed-form motion. Sides are those of the arena: a body that flies to
/// the right meets a right wall.
enum class ContactKind : std::uint8_t {
    none,
    left_wall,
    right_wall,
    ceiling,
    floor,
    edge,  ///< The floor ends under a sliding body.
    stop,  ///< Friction, or drag without gravity, has done its work.
};

struct Contact {
    double time = infinity;  ///< From the state on [s].
    ContactKind kind = ContactKind::none;
    double side = 0.0;  ///< Coordinate of what is met [px].
};

/// Where free motion, without any contact, leads after `t` [s].
inline BodyState free_motion(const BodyState& state, const Law& law, double t) {
    BodyState moved = state;
    if (state.mode == Mode::air) {
        const Flight flight(law.drag, t);
        const AxisState x = flight.from(state.velocity.x, 0.0);
        const AxisState y = flight.from(state.velocity.y, law.gravity);
        moved.position = state.position + Vec2{x.offset, y.offset};
        moved.velocity = {x.velocity, y.velocity};
    } else if (state.mode == Mode::ground) {
        const AxisState x = glide(state.velocity.x, law.ground_drag, t);
        moved.position.x += x.offset;
        moved.velocity.x = x.velocity;
    }
    return moved;
}

/// Which walls count as contacts.
enum class Walls : std::uint8_t { meet, ignore };

/// The first contact. `state` lies in the space.
Contact next_contact(
    const BodyState& state, const Law& law, const FreeSpace& space, Walls walls = Walls::meet
);

/// The state right after the contact, from the state that free motion leads to at its time.
BodyState after_contact(
    const Contact& contact, BodyState arriving, const Law& law, const FreeSpace& space
);

/// How a body that is let go here moves on: put into the space, on the ground if it lies on a floor
/// without vertical velocity, at rest if it is slow enough.
BodyState let_go(Vec2 position, Vec2 velocity, const Law& law, const FreeSpace& space);

}  // namespace hyrax
