// SPDX-License-Identifier: MIT
// Cells of sprite sheets as they are drawn, each made when it is first shown.
#pragma once

#include "daemon/core/image.h"
#include "daemon/core/sprite_set.h"
#include "physics/geometry.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace hyrax {

/// What is visible of a cell, as it is drawn.
struct CellPicture {
    const Image* image = nullptr;  ///< Without pixels if there is nothing to see.
    Point at;                      ///< Of its top-left corner, within the cell.
};

/// Each picture has pixels of its own and no more than can be seen: no neighbour can bleed into it,
/// and its rows lie close together in memory. Those that have not been shown for the longest time
/// go when all together exceed the limit.
class Atlas {
public:
    static constexpr std::size_t default_limit = std::size_t{128} << 20U;

    explicit Atlas(std::size_t limit_bytes = default_limit) : limit_(limit_bytes) {}

    /// What has been shown in this frame or the one before stays where it is: somebody may look at
    /// it, and no other picture takes its address. It may exceed the limit.
    void begin_frame() { ++frame_; }

    /// The cell in this size (positive). `set_index` names the set until clear().
    CellPicture cell(
        const SpriteSet& set, std::size_t set_index, int cell, bool faces_left, Size size
    );

    /// For other sets. Nobody may look at a picture any more.
    void clear();

    /// Of all pictures.
    std::size_t bytes() const { return bytes_; }
    /// How many pictures have been made since the start.
    std::uint64_t made() const { return made_; }

private:
    struct Picture {
        Image image;
        Point at;
        std::uint64_t frame = 0;  // When it was last shown; 0 until it is made.
    };
    // Both facings of each cell of a set in one size.
    using Scale = std::vector<Picture>;

    static Picture cut(const SpriteSet& set, int cell, bool faces_left, Size size);
    Scale& scale_of(const SpriteSet& set, std::size_t set_index, Size size);
    void drop_oldest();

    std::unordered_map<std::uint64_t, Scale> scales_;
    std::size_t limit_;
    std::size_t bytes_ = 0;
    std::uint64_t frame_ = 1;
    std::uint64_t made_ = 0;
};

}  // namespace hyrax
