// SPDX-License-Identifier: MIT
// What a pet is, and how others name it.
#pragma once

#include "physics/geometry.h"
#include "daemon/core/slot_map.h"
#include "physics/ticks.h"
#include "physics/physics.h"

#include <cstddef>
#include <optional>
#include <string>

namespace hyrax {

using PetId = SlotId;

/// How a pet moves. Which picture shows it follows from this and from the time (stage.h).
enum class Motion {
    airborne,  ///< In flight or bouncing.
    settled,   ///< On the ground, sliding or still.
    held,      ///< In the user's hand.
};

struct Pet {
    std::size_t kind = 0;  ///< Index into Engine::kinds().
    physics body;          ///< Position of the box's top-left corner, relative to `home`.
    Rect home;             ///< The box of the arena that it moves in.
    Vec2 spawn_position;   ///< Where reset() puts it, virtual desktop [px].
    Motion motion = Motion::airborne;
    Ticks since = 0;  ///< When this motion began.
    bool awake = false;
    bool faces_left = false;
    bool landed = false;              ///< The flight has met the floor.
    int frames_on_floor = 0;          ///< Consecutive steps that ended on the floor.
    std::optional<Ticks> stepped_at;  ///< Its last step; none before the first frame of a motion.
    std::string owner;                ///< Name of a script or plugin, or "user".
    std::string tag;                  ///< Free text of the owner.

    /// Top-left corner of the box, virtual desktop [px].
    Vec2 position() const { return {home.x + body.x(), home.y + body.y()}; }
    /// [px/s]
    Vec2 velocity() const { return {body.vx(), body.vy()}; }
};

}  // namespace hyrax
