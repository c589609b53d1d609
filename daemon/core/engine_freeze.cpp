// SPDX-License-Identifier: MIT
// Pets that stand still where others must not be disturbed: each has a time of its own, which
// begins again where it stopped.
#include "daemon/core/engine.h"

#include <algorithm>
#include <utility>

namespace hyrax {

void Engine::freeze(std::vector<Rect> areas, Ticks now) {
    if (areas == frozen_areas_) {
        return;
    }
    advance(now);
    frozen_areas_ = std::move(areas);
    pets_.for_each([this](PetId id, Pet& pet) { refresh_frozen(id, pet); });
}

bool Engine::in_frozen_area(const Pet& pet) const {
    const Size size = box_of(pet);
    const Vec2 at = pet.position();
    const Vec2 middle{at.x + size.width / 2.0, at.y + size.height / 2.0};
    return std::ranges::any_of(frozen_areas_, [&](const Rect& area) {
        return middle.x >= area.x && middle.x < area.right() && middle.y >= area.y &&
               middle.y < area.bottom();
    });
}

void Engine::refresh_frozen(PetId id, Pet& pet) {
    const bool stops = pet.motion != Motion::held && in_frozen_area(pet);
    if (stops == pet.frozen()) {
        return;
    }
    if (stops) {
        pet.frozen_at = now_;
        std::erase(awake_, id);
    } else {
        thaw(id, pet);
    }
}

void Engine::thaw(PetId id, Pet& pet) {
    pet.lost += now_ - pet.frozen_at;
    // A motion that was begun meanwhile begins now.
    pet.since += now_ - std::max(pet.since, pet.frozen_at);
    if (pet.playing) {
        pet.playing->since += now_ - std::max(pet.playing->since, pet.frozen_at);
    }
    pet.frozen_at = never;
    if (pet.awake) {
        awake_.push_back(id);
    }
}

}  // namespace hyrax
