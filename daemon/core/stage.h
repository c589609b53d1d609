// SPDX-License-Identifier: MIT
// From pets to pictures: which cell of which sheet stands where, and until when.
#pragma once

#include "daemon/core/atlas.h"
#include "daemon/core/engine.h"
#include "daemon/core/frame.h"
#include "daemon/core/sprite_set.h"
#include "physics/ticks.h"

#include <vector>

namespace hyrax {

/// The sets as far as motion depends on them, in their order.
std::vector<Kind> kinds_of(const std::vector<SpriteSet>& sets);

/// The cell for a motion that began `elapsed` ago: a settled pet lands, sits for `drowsy_after`,
/// lies down, and after a few breaths changes no more.
Shown pose(const SpriteSet& set, Motion motion, Ticks elapsed, Ticks drowsy_after);

struct Staged {
    Frame frame;
    Ticks next_change = never;      ///< When the next animation frame begins, if nobody moves.
    std::vector<PetId> speakers{};  ///< Those with a bubble, in drawing order.
};

/// When pets are looked at, and what they look like.
struct Scene {
    Ticks now = 0;
    Ticks drowsy_after = 0;
    double opacity = 1.0;  ///< Of all pets, above 0.
    bool calm = false;     ///< Animations of pets on the ground stand still.
};

/// `sets[i]` holds the pictures of `engine.kinds()[i]`. Sets and atlas must outlive the frame,
/// whose pictures stay until the next call but one. Frozen pets keep the pose that they had.
Staged staged(
    const Engine& engine, const std::vector<SpriteSet>& sets, Atlas& atlas, const Scene& scene
);

}  // namespace hyrax
