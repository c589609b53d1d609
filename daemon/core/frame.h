// SPDX-License-Identifier: MIT
// One picture of the whole desktop, as data.
#pragma once

#include "daemon/core/image.h"
#include "daemon/core/pet.h"
#include "physics/geometry.h"

#include <optional>
#include <vector>

namespace hyrax {

/// One drawn pet. `image` belongs to a sprite set and outlives the frame.
struct Sprite {
    const Image* image = nullptr;
    Rect source;  ///< Within the image.
    Point at;     ///< Of the source's top-left corner, virtual desktop [px].
    PetId pet;

    Rect bounds() const { return {at.x, at.y, source.width, source.height}; }
    bool operator==(const Sprite&) const = default;
};

/// In drawing order: the last sprite lies on top. Equal frames look the same.
struct Frame {
    std::vector<Sprite> sprites;
    /// Above them all; the pointer goes through. Each `pet` is whose it is.
    std::vector<Sprite> bubbles{};
    bool operator==(const Frame&) const = default;
};

/// The topmost pet with a visible pixel at the point.
std::optional<PetId> pet_at(const Frame& frame, Point point);

}  // namespace hyrax
