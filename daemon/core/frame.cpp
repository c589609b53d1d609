// SPDX-License-Identifier: MIT
#include "daemon/core/frame.h"

#include <algorithm>
#include <ranges>

namespace hyrax {

std::optional<PetId> pet_at(const Frame& frame, Point point) {
    for (const Sprite& sprite : frame.sprites | std::views::reverse) {
        if (!sprite.bounds().contains(point)) {
            continue;
        }
        const int x = sprite.source.x + point.x - sprite.at.x;
        const int y = sprite.source.y + point.y - sprite.at.y;
        if (alpha_of(sprite.image->at(x, y)) != 0) {
            return sprite.pet;
        }
    }
    return std::nullopt;
}

}  // namespace hyrax
