// SPDX-License-Identifier: MIT
// How a pet comes into the world: what is asked is checked first, and nothing happens if it fails.
#include "daemon/core/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyrax {

Result<void> require_finite(Vec2 v, std::string_view verb) {
    if (std::isfinite(v.x) && std::isfinite(v.y)) {
        return {};
    }
    return failure(fmt::format("{}: expected finite numbers, got ({}, {})", verb, v.x, v.y));
}

Result<PetId> Engine::spawn(const SpawnOptions& options) {
    const std::optional<std::size_t> kind = kind_named(options.kind);
    if (!kind) {
        return failure(fmt::format("spawn: there is no kind of pet named \"{}\"", options.kind));
    }
    if (pets_.size() >= settings_.max_pets) {
        return failure(fmt::format(
            "spawn: the population limit of {} pets is reached (config.json: /pets/max)",
            settings_.max_pets
        ));
    }
    if (arena_.empty()) {
        return failure("spawn: no monitor is known, so there is no place for a pet");
    }
    for (const Vec2 numbers : {options.velocity, options.at.value_or(Vec2{})}) {
        if (const auto checked = require_finite(numbers, "spawn"); !checked) {
            return std::unexpected(checked.error());
        }
    }
    for (const auto& checked :
         {require_scale(options.scale, "spawn"), require_opacity(options.opacity, "spawn")}) {
        if (!checked) {
            return std::unexpected(checked.error());
        }
    }

    const double rate = settings_.max_spawn_rate;
    const double at_once = static_cast<double>(settings_.max_pets) + rate;
    if (!spawns_.take(now_, {.at_once = at_once, .per_second = rate})) {
        return failure(fmt::format(
            "spawn: the limit of {} new pets a second is reached (config.json: "
            "/pets/max_spawn_rate)",
            settings_.max_spawn_rate
        ));
    }

    Pet pet;
    pet.kind = *kind;
    pet.owner = options.owner;
    pet.tag = options.tag;
    pet.scale = options.scale;
    pet.opacity = options.opacity;
    const Vec2 at = options.at ? *options.at : random_entrance();
    size_up(pet, at);
    place(pet, at);
    pet.spawn_position = pet.position();
    pet.faces_left = options.velocity.x < 0.0;
    const PetId id = pets_.insert(std::move(pet));
    launch(id, *pets_.find(id), options.velocity);
    emit({.kind = EventKind::spawn, .pet = id});
    return id;
}

Vec2 Engine::random_entrance() {
    const std::vector<Rect>& boxes = arena_.boxes();
    const auto index = static_cast<std::size_t>(random_unit() * static_cast<double>(boxes.size()));
    const Rect& box = boxes[std::min(index, boxes.size() - 1)];
    return {box.x + random_unit() * box.width, static_cast<double>(box.y)};
}

double Engine::random_unit() {
    // minstd_rand is specified to the bit; the library's distributions are not.
    return static_cast<double>(random_() - std::minstd_rand::min()) /
           (static_cast<double>(std::minstd_rand::max() - std::minstd_rand::min()) + 1.0);
}

}  // namespace hyrax
