// SPDX-License-Identifier: MIT
// What a pet is, and how others name it.
#pragma once

#include "daemon/core/slot_map.h"
#include "physics/body.h"
#include "physics/geometry.h"
#include "physics/ticks.h"

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
    walking,   ///< On the ground, by itself.
};

/// A walk along the floor at a constant speed. It waits until the pet is on the ground.
struct Walk {
    double target = 0.0;  ///< Where the left edge of the box is to be [px].
    double speed = 0.0;   ///< Positive [px/s].
    bool begun = false;
    // What follows counts once it has begun.
    Vec2 from{};
    Ticks since = 0;
    Ticks until = 0;     ///< At the target, at a wall or at the edge of the floor.
    Vec2 velocity{};     ///< [px/s]
    double end = 0.0;    ///< Where it ends [px].
    bool falls = false;  ///< It ends at an edge, and the pet walks on into the air.
};

/// An animation instead of that of the pet's motion.
struct Playing {
    std::string animation;
    std::optional<bool> loop{};   ///< None: as the animation is made.
    std::optional<double> fps{};  ///< None: as its frames last.
    Ticks since = 0;
};

struct Speech {
    std::string text;
    Ticks until = 0;
};

struct Pet {
    std::size_t kind = 0;      ///< Index into Engine::kinds().
    Body body;                 ///< Its motion; unused while a hand holds it.
    Rect home;                 ///< The room that the document's law keeps it in.
    Vec2 spawn_position;       ///< Where reset() puts it, virtual desktop [px].
    BodyState shown;           ///< As of the last frame, or as put since.
    double scale = 1.0;        ///< Its own, 0.25 to 4.
    double drawn_scale = 1.0;  ///< With the scales of its kind, of the settings and of its screen.
    std::size_t space = 0;     ///< Index into the engine's Spaces, by the size of its box.
    double opacity = 1.0;      ///< 0.1 to 1, beside that of all pets.
    std::size_t screen = 0;    ///< Index of the arena's box whose scale counts.
    Motion motion = Motion::airborne;
    Ticks since = 0;          ///< When this motion began.
    Ticks frozen_at = never;  ///< When it was frozen; `never` if it is not.
    Ticks lost = 0;           ///< Time that it was frozen: its body's time is that much behind.
    bool awake = false;
    bool started = false;  ///< The body moves; its first frame shows it where it was put.
    bool faces_left = false;
    bool landed = false;   ///< The flight has met a floor.
    bool arrives = false;  ///< Its screen has gone: it comes to another one with the next frame.
    std::optional<Ticks> arrived{};  ///< When it came from a screen that has gone.
    std::string owner;               ///< Name of a script or plugin, or "user".
    std::string tag;                 ///< Free text of the owner.
    std::optional<Walk> walk{};
    std::optional<Playing> playing{};
    std::optional<Speech> speech{};

    /// Top-left corner of the box, virtual desktop [px].
    Vec2 position() const { return shown.position; }
    /// [px/s]
    Vec2 velocity() const { return shown.velocity; }
    bool frozen() const { return frozen_at != never; }
};

}  // namespace hyrax
