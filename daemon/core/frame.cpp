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
        if (alpha_of(sprite.image->at(point.x - sprite.at.x, point.y - sprite.at.y)) != 0) {
            return sprite.pet;
        }
    }
    return std::nullopt;
}

}  // namespace hyrax
