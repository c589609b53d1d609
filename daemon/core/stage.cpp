// SPDX-License-Identifier: MIT
#include "daemon/core/stage.h"

#include "daemon/core/playing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace hyrax {
namespace {

// A resting pet breathes for a while and then lies still: a desktop at rest wakes nothing.
constexpr int breaths = 6;
constexpr double fade_in = 250.0 * ticks_per_ms;
constexpr Ticks fade_step = 16 * ticks_per_ms;

Shown later(Shown shown, Ticks offset) {
    return {shown.cell, shown.until == never ? never : shown.until + offset};
}

Shown settled_pose(const SpriteSet& set, Ticks elapsed, Ticks drowsy_after) {
    Ticks begin = 0;
    if (const auto land = set.animations.find("land"); land != set.animations.end()) {
        begin = land->second.duration();
        if (elapsed < begin) {
            const Shown shown = shown_at(land->second, elapsed);
            return {shown.cell, std::min(shown.until, begin)};
        }
    }
    const Ticks lies_down = begin + drowsy_after;
    const auto rest = set.animations.find("rest");
    if (rest != set.animations.end() && elapsed >= lies_down) {
        const Ticks still_from = lies_down + breaths * rest->second.duration();
        const Shown shown = later(shown_at(rest->second, elapsed - lies_down), lies_down);
        return elapsed < still_from ? shown : Shown{rest->second.frames.back().cell, never};
    }
    Shown idle = later(shown_at(set.animation("idle"), elapsed - begin), begin);
    if (rest != set.animations.end()) {
        idle.until = std::min(idle.until, lies_down);
    }
    return idle;
}

// Sits, then lies, and does nothing else.
Shown calm_pose(const SpriteSet& set, Ticks elapsed, Ticks drowsy_after) {
    const auto rest = set.animations.find("rest");
    if (rest == set.animations.end()) {
        return {set.animation("idle").frames.front().cell, never};
    }
    return elapsed < drowsy_after ? Shown{set.animation("idle").frames.front().cell, drowsy_after}
                                  : Shown{rest->second.frames.back().cell, never};
}

// The pet's box stands where physics says; the cell hangs around it, feet on feet: both were
// rounded to whole pixels on their own.
Point cell_corner(const SpriteSet& set, const Pet& pet, Size box, Size cell) {
    const double across = static_cast<double>(cell.width) / set.cell.width;
    const double down = static_cast<double>(cell.height) / set.cell.height;
    const double middle = set.box.x + set.box.width / 2.0;
    const double feet_x = (pet.faces_left ? set.cell.width - middle : middle) * across;
    const double feet_y = set.box.bottom() * down;
    const Vec2 at = pet.position();
    return {
        static_cast<int>(std::lround(at.x) - std::lround(feet_x - box.width / 2.0)),
        static_cast<int>(std::lround(at.y) - std::lround(feet_y - box.height)),
    };
}

// Fainter, a pet could be lost; and what cannot be seen must not catch clicks.
std::uint8_t opacity_of(double share) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(share, least_opacity, 1.0) * 255.0));
}

/// How much of a pet that comes from a screen that has gone is seen by now.
double appeared(const Pet& pet, Ticks now) {
    return pet.arrived && !pet.frozen() ? static_cast<double>(now - *pet.arrived) / fade_in : 1.0;
}

struct ShownSince {
    Shown shown;
    Ticks since;  // From when on its times count.
};

ShownSince shown_now(const SpriteSet& set, const Pet& pet, const Scene& scene) {
    const Ticks now = std::min(scene.now, pet.frozen_at);
    const bool calm = scene.calm && pet.motion == Motion::settled;
    if (pet.playing && !calm) {
        const auto found = set.animations.find(pet.playing->animation);
        const Ticks elapsed = std::max<Ticks>(0, now - pet.playing->since);
        if (found != set.animations.end()) {
            if (const auto shown = shown_of(*pet.playing, found->second, elapsed)) {
                return {*shown, pet.playing->since};
            }
        }
    }
    const Ticks elapsed = std::max<Ticks>(0, now - pet.since);
    return {
        calm ? calm_pose(set, elapsed, scene.drowsy_after)
             : pose(set, pet.motion, elapsed, scene.drowsy_after),
        pet.since
    };
}

}  // namespace

std::vector<Kind> kinds_of(const std::vector<SpriteSet>& sets) {
    std::vector<Kind> kinds;
    for (const SpriteSet& set : sets) {
        const int side = std::max(set.cell.width, set.cell.height);
        Kind& kind = kinds.emplace_back(Kind{
            .name = set.name,
            .box = {set.box.width, set.box.height},
            .scale = set.scale,
            .whole_scale = set.filter == Filter::nearest,
            .largest_scale = std::clamp(2048.0 / side, 1.0, 8.0),
        });
        for (const auto& [name, animation] : set.animations) {
            kind.animations.push_back(name);
        }
    }
    return kinds;
}

Shown pose(const SpriteSet& set, Motion motion, Ticks elapsed, Ticks drowsy_after) {
    switch (motion) {
        case Motion::airborne:
            return shown_at(set.animation("fall"), elapsed);
        case Motion::held:
            return shown_at(set.animation("held"), elapsed);
        case Motion::walking:
            return shown_at(set.animation("walk"), elapsed);
        case Motion::settled:
            return settled_pose(set, elapsed, drowsy_after);
    }
    std::unreachable();
}

Staged staged(
    const Engine& engine, const std::vector<SpriteSet>& sets, Atlas& atlas, const Scene& scene
) {
    Staged result;
    result.frame.sprites.reserve(engine.size());
    atlas.begin_frame();
    engine.for_each([&](PetId id, const Pet& pet) {
        const SpriteSet& set = sets[pet.kind];
        const auto [shown, since] = shown_now(set, pet, scene);
        const Size size = scaled(set.cell, pet.drawn_scale);
        const CellPicture picture = atlas.cell(set, pet.kind, shown.cell, pet.faces_left, size);
        const Point corner = cell_corner(set, pet, engine.box_of(pet), size);
        if (!picture.image->pixels.empty()) {
            const Point at{corner.x + picture.at.x, corner.y + picture.at.y};
            const double seen = std::min(appeared(pet, scene.now), 1.0);
            const std::uint8_t opacity = opacity_of(scene.opacity * pet.opacity * seen);
            if (seen < 1.0) {
                result.next_change = std::min(result.next_change, scene.now + fade_step);
            }
            result.frame.sprites.emplace_back(*picture.image, at, id, opacity);
        }
        if (shown.until != never && !pet.frozen()) {
            result.next_change = std::min(result.next_change, since + shown.until);
        }
        if (pet.speech && scene.now < pet.speech->until) {
            result.speakers.push_back(id);
            result.next_change = std::min(result.next_change, pet.speech->until);
        }
    });
    return result;
}

}  // namespace hyrax
