// SPDX-License-Identifier: MIT
// What pets do by themselves: walk, play, speak. A walk is a motion of constant speed whose end is
// known when it begins, so that it is the same at any frame rate.
#include "daemon/core/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyrax {

Result<void> Engine::walk_to(PetId id, double x, double speed) {
    if (!(speed > 0.0)) {
        return failure(fmt::format("walk_to: expected a speed above 0, got {}", speed));
    }
    const Result<Pet*> found = pet_for(id, "walk_to", {x, speed});
    if (!found) {
        return std::unexpected(found.error());
    }
    Pet& pet = **found;
    if (pet.motion == Motion::held) {
        return {};
    }
    pet.playing.reset();
    pet.walk = Walk{.target = x, .speed = std::min(speed, settings_.max_speed)};
    // Whoever already moves on the ground turns at once; others begin with the next frame.
    if (pet.awake && pet.started && pet.shown.mode != Mode::air) {
        begin_walk(pet, own_time(pet), pet.position());
    } else if (!pet.awake) {
        pet.awake = true;
        if (!pet.frozen()) {
            awake_.push_back(id);
        }
    }
    return {};
}

// True if the pet walks at `now`, by its own time; else its body is to be read.
bool Engine::walks(PetId id, Pet& pet, Ticks now) {
    if (!pet.walk->begun) {
        // Who comes to the ground within this frame begins at that very moment.
        std::optional<std::pair<Ticks, Vec2>> settled;
        pet.body.advance(now, rules_, around(pet), [&](const TrajectoryEvent& event) {
            if (settled) {
                return;
            }
            meet(id, pet, event);
            if (pet.body.mode() != Mode::air) {
                settled = {event.time, pet.body.at(event.time, rules_, around(pet)).position};
            }
        });
        if (!settled && pet.body.mode() == Mode::air) {
            return false;
        }
        if (!settled) {
            settled = {now, pet.body.at(now, rules_, around(pet)).position};
        }
        begin_walk(pet, settled->first, settled->second);
    }
    if (pet.walk && now < pet.walk->until) {
        const Walk& walk = *pet.walk;
        const double x = walk.from.x + walk.velocity.x * to_seconds(now - walk.since);
        pet.shown = {{x, walk.from.y}, walk.velocity, Mode::ground};
        return true;
    }
    if (pet.walk) {
        end_walk(pet);
    }
    return false;
}

// The walk as it goes from here; nothing where there is no floor.
std::optional<Walk> Engine::way_to_target(const Pet& pet, Vec2 from) const {
    const FreeSpace& space = spaces_[pet.space];
    const Vec2 corner = from + space.overhang();
    const std::optional<Support> floor = space.support(corner);
    if (!floor) {
        return std::nullopt;
    }
    Walk walk = *pet.walk;
    const Support walls = space.corridor(corner);
    const bool left = walk.target < from.x;
    const double wanted = walk.target + space.overhang().x;
    const double last =
        left ? std::max(walls.left, floor->left) : std::min(walls.right, floor->right);
    const double end = left ? std::max(wanted, last) : std::min(wanted, last);
    walk.from = from;
    walk.velocity = {left ? -walk.speed : walk.speed, 0.0};
    walk.end = end - space.overhang().x;
    walk.falls = end != wanted && (left ? floor->left > walls.left : floor->right < walls.right);
    return walk;
}

// The pet stands at `from` at this time; without a floor there is no walk.
void Engine::begin_walk(Pet& pet, Ticks time, Vec2 from) {
    const std::optional<Walk> way = way_to_target(pet, from);
    if (!way) {
        pet.walk.reset();
        pet.shown.position = from;
        relaunch(pet, {});
        pet.body.start(time);
        pet.started = true;
        return;
    }
    pet.walk = *way;
    pet.walk->begun = true;
    pet.walk->since = time;
    pet.walk->until = time + from_seconds(std::fabs(way->end - from.x) / way->speed);
    pet.faces_left = way->velocity.x < 0.0;
}

// True if the walk would now end elsewhere than when it began.
bool Engine::walk_is_outdated(const Pet& pet) const {
    if (!pet.walk || !pet.walk->begun) {
        return false;
    }
    const std::optional<Walk> way = way_to_target(pet, pet.position());
    return !way || way->end != pet.walk->end || way->falls != pet.walk->falls;
}

void Engine::end_walk(Pet& pet) {
    const Walk walk = *std::exchange(pet.walk, std::nullopt);
    pet.body.launch(
        {walk.end, walk.from.y},
        walk.falls ? walk.velocity : Vec2{},
        rules_,
        around(pet),
        wall_events()
    );
    pet.body.start(walk.until);
}

Result<void> Engine::play(PetId id, Playing playing) {
    const Result<Pet*> found = pet_for(id, "play", {playing.fps.value_or(1.0), 0.0});
    if (!found) {
        return std::unexpected(found.error());
    }
    Pet& pet = **found;
    const Kind& kind = kinds_[pet.kind];
    if (!kind.animations.empty() &&
        std::ranges::find(kind.animations, playing.animation) == kind.animations.end()) {
        return failure(fmt::format(
            "play: \"{}\" has no animation \"{}\" (there are: {})",
            kind.name,
            playing.animation,
            fmt::join(kind.animations, ", ")
        ));
    }
    if (playing.fps && !(*playing.fps >= least_fps && *playing.fps <= most_fps)) {
        return failure(fmt::format(
            "play: expected from {} to {} frames/s, got {}", least_fps, most_fps, *playing.fps
        ));
    }
    if (pet.motion != Motion::held) {
        playing.since = now_;
        pet.playing = std::move(playing);
    }
    return {};
}

Result<void> Engine::say(PetId id, std::string text, double seconds) {
    const Result<Pet*> found = pet_for(id, "say", {seconds, 0.0});
    if (!found) {
        return std::unexpected(found.error());
    }
    std::optional<Speech>& speech = (*found)->speech;
    speech.reset();
    if (!text.empty() && seconds > 0.0) {
        speech = Speech{std::move(text), now_ + from_seconds(std::min(seconds, longest_speech))};
    }
    return {};
}

Result<void> Engine::face(PetId id, bool left) {
    const Result<Pet*> found = pet_for(id, "face", {});
    if (!found) {
        return std::unexpected(found.error());
    }
    (*found)->faces_left = left;
    return {};
}

void Engine::listen(EventMask mask) {
    listening_ = mask;
    if (!is_heard(EventKind::collide)) {
        collisions_.forget();
    }
}

void Engine::watch(EventMask mask) {
    watching_ = mask;
    if (!is_heard(EventKind::collide)) {
        collisions_.forget();
    }
}

void Engine::find_collisions() {
    collisions_.begin(pets_.size());
    pets_.for_each([this](PetId id, const Pet& pet) {
        collisions_.add({id, pet.position(), box_of(pet), pet.velocity()});
    });
    for (const Collision& met : collisions_.find()) {
        emit({.kind = EventKind::collide, .pet = met.a, .speed = met.speed, .other = met.b});
    }
}

}  // namespace hyrax
