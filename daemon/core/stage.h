// SPDX-License-Identifier: MIT
// From pets to pictures: which cell of which sheet stands where, and until when.
#pragma once

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

/// `sets[i]` holds the pictures of `engine.kinds()[i]` and must outlive the frame.
Staged staged(
    const Engine& engine, const std::vector<SpriteSet>& sets, Ticks now, Ticks drowsy_after
);

}  // namespace hyrax
