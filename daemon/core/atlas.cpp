// SPDX-License-Identifier: MIT
#include "daemon/core/atlas.h"

#include "daemon/core/resample.h"

#include <algorithm>

namespace hyrax {
namespace {

std::size_t bytes_of(const Image& image) {
    return image.pixels.size() * sizeof(Pixel);
}

}  // namespace

CellPicture Atlas::cell(
    const SpriteSet& set, std::size_t set_index, int cell, bool faces_left, Size size
) {
    const std::size_t place = 2 * static_cast<std::size_t>(cell) + (faces_left ? 1 : 0);
    Picture& picture = scale_of(set, set_index, size)[place];
    if (picture.frame == 0) {
        picture = cut(set, cell, faces_left, size);
        picture.frame = frame_;
        bytes_ += bytes_of(picture.image);
        ++made_;
        if (bytes_ > limit_) {
            drop_oldest();
        }
    }
    picture.frame = frame_;
    return {&picture.image, picture.at};
}

Atlas::Picture Atlas::cut(const SpriteSet& set, int cell, bool faces_left, Size size) {
    Rect whole = set.cell_rect(cell);
    const Image* from = &set.sheet;
    Image scaled;
    if (size != set.cell) {
        scaled = resampled(set.sheet, whole, size, set.filter);
        whole = {0, 0, size.width, size.height};
        from = &scaled;
    }
    const Rect seen = visible_part(*from, whole);
    Picture picture;
    picture.image = part_of(*from, seen);
    picture.at = {seen.x - whole.x, seen.y - whole.y};
    if (faces_left) {
        mirror(picture.image);
        picture.at.x = size.width - picture.at.x - seen.width;
    }
    return picture;
}

void Atlas::clear() {
    scales_.clear();
    bytes_ = 0;
}

Atlas::Scale& Atlas::scale_of(const SpriteSet& set, std::size_t set_index, Size size) {
    // A cell has no side of 2^24 pixels, and there are no 2^16 sets.
    const std::uint64_t key = std::uint64_t{set_index} << 48U |
                              static_cast<std::uint64_t>(size.width) << 24U |
                              static_cast<std::uint64_t>(size.height);
    const auto [entry, is_new] = scales_.try_emplace(key);
    if (is_new) {
        const int columns = set.sheet.size.width / set.cell.width;
        const int rows = set.sheet.size.height / set.cell.height;
        entry->second.resize(2 * static_cast<std::size_t>(columns * rows));
    }
    return entry->second;
}

void Atlas::drop_oldest() {
    std::vector<Picture*> old;
    for (auto& [key, scale] : scales_) {
        for (Picture& picture : scale) {
            if (picture.frame != 0 && picture.frame + 1 < frame_) {
                old.push_back(&picture);
            }
        }
    }
    std::ranges::sort(old, {}, &Picture::frame);
    for (Picture* const picture : old) {
        if (bytes_ <= limit_) {
            break;
        }
        bytes_ -= bytes_of(picture->image);
        *picture = {};
    }
    std::erase_if(scales_, [](const auto& entry) {
        return std::ranges::all_of(entry.second, [](const Picture& picture) {
            return picture.frame == 0;
        });
    });
}

}  // namespace hyrax
