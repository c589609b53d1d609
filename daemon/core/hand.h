// SPDX-License-Identifier: MIT
// The user's hand: from pointer samples to where a held pet is and how it is thrown.
#pragma once

#include "physics/geometry.h"
#include "daemon/core/pet.h"
#include "physics/ticks.h"

#include <optional>
#include <vector>

namespace hyrax {

/// Holds at most one pet. Positions in virtual desktop pixels.
class Hand {
public:
    /// `grip` is the pet's position minus the pointer's.
    void take(PetId pet, Vec2 grip, Point at, Ticks time);
    void move(Point at, Ticks time);
    void drop() { pet_.reset(); }

    std::optional<PetId> pet() const { return pet_; }
    /// Where the held pet's top-left corner belongs.
    Vec2 carried_to() const;
    /// Slope of a straight line fitted to the samples of the last 100 ms [px/s]; zero when the hand
    /// stood still for the last 80 ms. Not longer than `limit`.
    Vec2 throw_velocity(Ticks now, double limit) const;
    /// A press and release on one spot within 400 ms.
    bool was_click(Ticks now) const;

private:
    struct Sample {
        Point at;
        Ticks time = 0;
    };
    std::optional<PetId> pet_;
    Vec2 grip_;
    Sample taken_;
    bool moved_ = false;
    std::vector<Sample> samples_;  ///< Oldest first, none older than the newest by over 100 ms.
};

}  // namespace hyrax
