// SPDX-License-Identifier: MIT
#include "daemon/core/stage.h"

#include "daemon/core/playing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyrax {
namespace {

// A resting pet breathes for a while and then lies still: a desktop at rest wakes nothing.
constexpr int breaths = 6;

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

// The pet's box stands where physics says; the cell hangs around it.
Point cell_corner(const SpriteSet& set, const Pet& pet) {
    const Vec2 box = pet.position();
    const int inset = pet.faces_left ? set.cell.width - set.box.x - set.box.width : set.box.x;
    return {
        static_cast<int>(std::lround(box.x)) - inset,
        static_cast<int>(std::lround(box.y)) - set.box.y,
    };
}

struct ShownSince {
    Shown shown;
    Ticks since;  // From when on its times count.
};

ShownSince shown_now(const SpriteSet& set, const Pet& pet, Ticks now, Ticks drowsy_after) {
    if (pet.playing) {
        const auto found = set.animations.find(pet.playing->animation);
        const Ticks elapsed = std::max<Ticks>(0, now - pet.playing->since);
        if (found != set.animations.end()) {
            if (const auto shown = shown_of(*pet.playing, found->second, elapsed)) {
                return {*shown, pet.playing->since};
            }
        }
    }
    const Ticks elapsed = std::max<Ticks>(0, now - pet.since);
    return {pose(set, pet.motion, elapsed, drowsy_after), pet.since};
}

}  // namespace

std::vector<Kind> kinds_of(const std::vector<SpriteSet>& sets) {
    std::vector<Kind> kinds;
    for (const SpriteSet& set : sets) {
        Kind& kind = kinds.emplace_back();
        kind.name = set.name;
        kind.box = {set.box.width, set.box.height};
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
    const Engine& engine, const std::vector<SpriteSet>& sets, Ticks now, Ticks drowsy_after
) {
    Staged result;
    result.frame.sprites.reserve(engine.size());
    engine.for_each([&](PetId id, const Pet& pet) {
        const SpriteSet& set = sets[pet.kind];
        const auto [shown, since] = shown_now(set, pet, now, drowsy_after);
        result.frame.sprites.push_back({
            .image = pet.faces_left ? &set.mirrored : &set.sheet,
            .source = set.cell_rect(shown.cell),
            .at = cell_corner(set, pet),
            .pet = id,
        });
        if (shown.until != never) {
            result.next_change = std::min(result.next_change, since + shown.until);
        }
        if (pet.speech && now < pet.speech->until) {
            result.speakers.push_back(id);
            result.next_change = std::min(result.next_change, pet.speech->until);
        }
    });
    return result;
}

}  // namespace hyrax
