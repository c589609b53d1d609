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
    const Image& sheet = faces_left ? set.mirrored : set.sheet;
    const Rect source = set.cell_rect(cell);
    if (size == set.cell) {
        const Rect part = set.visible_in(cell, faces_left);
        return {
            &sheet,
            {source.x + part.x, source.y + part.y, part.width, part.height},
            {part.x, part.y}
        };
    }
    const std::size_t place = 2 * static_cast<std::size_t>(cell) + (faces_left ? 1 : 0);
    Scaled& scaled = scale_of(set, set_index, size)[place];
    scaled.frame = frame_;
    if (scaled.image.pixels.empty()) {
        scaled.image = resampled(sheet, source, size, set.filter);
        scaled.visible = visible_part(scaled.image, {0, 0, size.width, size.height});
        bytes_ += bytes_of(scaled.image);
        ++made_;
        if (bytes_ > limit_) {
            drop_oldest();
        }
    }
    return {&scaled.image, scaled.visible, {scaled.visible.x, scaled.visible.y}};
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
    std::vector<Scaled*> old;
    for (auto& [key, scale] : scales_) {
        for (Scaled& scaled : scale) {
            if (!scaled.image.pixels.empty() && scaled.frame + 1 < frame_) {
                old.push_back(&scaled);
            }
        }
    }
    std::ranges::sort(old, {}, &Scaled::frame);
    for (Scaled* const scaled : old) {
        if (bytes_ <= limit_) {
            break;
        }
        bytes_ -= bytes_of(scaled->image);
        scaled->image = {};
    }
    std::erase_if(scales_, [](const auto& entry) {
        return std::ranges::all_of(entry.second, [](const Scaled& scaled) {
            return scaled.image.pixels.empty();
        });
    });
}

}  // namespace hyrax
