// SPDX-License-Identifier: MIT
// Animations that a script asked for.
#pragma once

#include "daemon/core/pet.h"
#include "daemon/core/sprite_set.h"
#include "physics/ticks.h"

#include <optional>

namespace hyrax {

/// What an animation shows `elapsed` after play(), >= 0; nothing once it is over.
std::optional<Shown> shown_of(const Playing& playing, const Animation& animation, Ticks elapsed);

}  // namespace hyrax
