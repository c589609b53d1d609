// SPDX-License-Identifier: MIT
// The pictures of one kind of pet: a sheet of cells and the animations made of them.
#pragma once

#include "daemon/core/image.h"
#include "daemon/core/resample.h"
#include "daemon/core/result.h"
#include "physics/ticks.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

struct AnimationFrame {
    int cell = 0;        ///< Row-major index into the sheet.
    Ticks duration = 0;  ///< > 0
};

struct Animation {
    std::vector<AnimationFrame> frames;  ///< Never empty.
    bool loop = false;                   ///< Otherwise the last frame stays.

    /// Sum of the frames.
    Ticks duration() const;
};

/// What an animation shows at a moment, and until when.
struct Shown {
    int cell = 0;
    Ticks until = never;  ///< Elapsed time at which the cell changes; `never` for the last one.
};

/// `elapsed` since the animation began, >= 0.
Shown shown_at(const Animation& animation, Ticks elapsed);

struct SpriteSet {
    std::string name;
    Image sheet;  ///< As drawn, facing right.
    Size cell;
    Rect box;                        ///< Within the cell: what meets walls and floor.
    double scale = 1.0;              ///< least_scale to most_scale (engine.h).
    Filter filter = Filter::smooth;  ///< For other sizes than its own.
    std::map<std::string, Animation, std::less<>> animations;

    /// The cell's rectangle in the sheet.
    Rect cell_rect(int index) const;
    /// The animation of this name, else "idle", which every set has.
    const Animation& animation(std::string_view animation_name) const;
};

/// What the sheets of all sets that are loaded at a time have at most: 128 MiB.
inline constexpr std::size_t most_sheet_pixels = std::size_t{32} << 20U;

/// Reads <folder>/sprite.json and its sheet. The message of a failure names the file and the key.
/// Pixels with alpha below 8 are cleared, so that shadows nobody sees do not catch clicks. A sheet
/// with more pixels than `room`, which other sets have left, is not decoded.
[[nodiscard]] Result<SpriteSet> load_sprite_set(
    const std::filesystem::path& folder,
    const ImageDecoder& decode,
    std::size_t room = most_sheet_pixels
);

/// A plain round pet, drawn by code: for a folder in which no sprite set can be read.
SpriteSet placeholder_sprite_set(std::string name);

}  // namespace hyrax
