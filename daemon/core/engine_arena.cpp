// SPDX-License-Identifier: MIT
// Pets in an arena that changes.
#include "daemon/core/engine.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace hyrax {

void Engine::set_arena(Arena arena) {
    const std::vector<Rect> former = arena_.boxes();
    arena_ = std::move(arena);
    lay_ledges();
    emit({.kind = EventKind::monitors});
    spaces_.set_arena(arena_);
    mind_screens();
    if (arena_.empty()) {
        return;
    }
    const bool other_boxes = former != arena_.boxes();
    pets_.for_each([&](PetId id, Pet& pet) {
        pet.screen = arena_.index_near(feet(pet));
        const bool resized = fit(id, pet);
        if (pet.motion != Motion::held) {
            move_into_arena(id, pet, other_boxes || resized);
        }
    });
}

// Who may stay stays, velocity and all. Who is inside a new wall is put before it and no longer
// moves against it; who has lost its screen arrives on the next one at rest.
void Engine::move_into_arena(PetId id, Pet& pet, bool disturbed) {
    const Vec2 before = pet.position();
    const Size size = box_of(pet);
    const Rect box{static_cast<int>(before.x), static_cast<int>(before.y), size.width, size.height};
    place(pet, before);
    const Vec2 moved = pet.position() - before;
    if (moved == Vec2{} && !disturbed) {
        return;
    }
    const bool on_a_screen = std::ranges::any_of(arena_.boxes(), [&box](const Rect& room) {
        return !intersection(room, box).empty();
    });
    Vec2 velocity = on_a_screen ? pet.velocity() : Vec2{};
    pet.arrives = pet.arrives || !on_a_screen;
    if (moved.x * velocity.x < 0.0) {
        velocity.x = 0.0;
    }
    if (moved.y * velocity.y < 0.0) {
        velocity.y = 0.0;
    }
    set_in_motion(id, pet, velocity);
}

}  // namespace hyrax
