// SPDX-License-Identifier: MIT
// The user's hand: which pet it holds, and where the pointer wants it.
#pragma once

#include "daemon/core/pet.h"
#include "physics/geometry.h"
#include "physics/ticks.h"

#include <optional>

namespace hyrax {

/// Holds at most one pet. Positions in virtual desktop pixels.
class Hand {
public:
    /// `grip` is the pet's position minus the pointer's.
    void take(PetId pet, Vec2 grip, Point at, Ticks time);
    /// False if the pointer is where it was: windows that come and go under it make it say so.
    bool move(Point at);
    void drop() { pet_.reset(); }

    std::optional<PetId> pet() const { return pet_; }
    /// Where the held pet's top-left corner belongs.
    Vec2 carried_to() const;
    /// A press and release on one spot within 400 ms.
    bool was_click(Ticks now) const;

private:
    std::optional<PetId> pet_;
    Vec2 grip_;
    Point at_;
    Point taken_at_;
    Ticks taken_time_ = 0;
    bool moved_ = false;
};

}  // namespace hyrax
