// SPDX-License-Identifier: MIT
// One picture of the whole desktop, as data.
#pragma once

#include "daemon/core/image.h"
#include "daemon/core/pet.h"
#include "physics/geometry.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace hyrax {

/// One drawn pet. Its image belongs to the atlas or to a speech, and outlives the frame and the one
/// after it, if that is of the same edition. Where a sprite stood can be told for longer.
struct Sprite {
    Sprite(const Image& picture, Point corner, PetId whose, std::uint8_t opacity_of_all = 255)
        : image(&picture), at(corner), size(picture.size), pet(whose), opacity(opacity_of_all) {}

    const Image* image;
    Point at;  ///< Of the image's top-left corner, virtual desktop [px].
    Size size;
    PetId pet;
    std::uint8_t opacity;  ///< Of the whole sprite, above 0.

    Rect bounds() const { return {at.x, at.y, size.width, size.height}; }
    bool operator==(const Sprite&) const = default;
};

/// In drawing order: the last sprite lies on top. Equal frames look the same.
struct Frame {
    std::vector<Sprite> sprites;
    /// Above them all; the pointer goes through. Each `pet` is whose it is.
    std::vector<Sprite> bubbles{};
    /// Bounds of the monitors that show nothing of it: no window may be there.
    std::vector<Rect> kept_free{};
    /// Images of another edition are others, even at the same address.
    std::uint64_t edition = 0;
    bool operator==(const Frame&) const = default;
};

/// Who draws frames into pixels.
enum class Renderer : std::uint8_t {
    blit,     ///< blit.h
    gdiplus,  ///< GDI+, on Windows; elsewhere the same as blit.
};

/// The topmost pet with a visible pixel at the point.
std::optional<PetId> pet_at(const Frame& frame, Point point);

}  // namespace hyrax
