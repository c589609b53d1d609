// SPDX-License-Identifier: MIT
// The frame: every pet that is awake moves on, and what it met becomes events.
#include "daemon/core/engine.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyrax {
namespace {

// Slower than this a pet does not turn round [px/s].
constexpr double turning_speed = 5.0;

// Slower, and nearer to the pointer, than this a held pet hangs still [px/s] [px].
constexpr double still_speed = 0.5;
constexpr double still_distance = 0.05;

Motion motion_of(Mode mode) {
    return mode == Mode::air ? Motion::airborne : Motion::settled;
}

std::optional<Side> side_of(ContactKind kind) {
    switch (kind) {
        case ContactKind::left_wall:
            return Side::left;
        case ContactKind::right_wall:
            return Side::right;
        case ContactKind::ceiling:
            return Side::top;
        case ContactKind::floor:
            return Side::bottom;
        case ContactKind::none:
        case ContactKind::edge:
        case ContactKind::stop:
            break;
    }
    return std::nullopt;
}

}  // namespace

void Engine::advance(Ticks now) {
    if (now < now_) {
        return;
    }
    now_ = now;
    // Pets may fall asleep here, never wake others, so one pass compacts the list in place.
    std::erase_if(awake_, [this, now](PetId id) {
        Pet& pet = *pets_.find(id);
        advance(id, pet, now);
        if (!frozen_areas_.empty() && in_frozen_area(pet)) {
            pet.frozen_at = now;
        }
        return !pet.awake || pet.frozen();
    });
    if (is_heard(EventKind::collide)) {
        find_collisions();
    }
}

void Engine::advance(PetId id, Pet& pet, Ticks now) {
    const Ticks own = now - pet.lost;
    if (!std::exchange(pet.started, true)) {
        pet.body.start(own);
        if (std::exchange(pet.arrives, false)) {
            pet.arrived = now;
        }
    }
    const bool walking = pet.walk && walks(id, pet, own);
    if (!walking) {
        pet.body.advance(own, rules_, around(pet), [&](const TrajectoryEvent& event) {
            meet(id, pet, event);
        });
        pet.shown = pet.body.at(own, rules_, around(pet));
    }
    if (std::fabs(pet.shown.velocity.x) > turning_speed) {
        pet.faces_left = pet.shown.velocity.x < 0.0;
    }
    const Motion motion = walking ? Motion::walking : motion_of(pet.shown.mode);
    if (motion != pet.motion) {
        pet.motion = motion;
        pet.since = now;
        pet.landed = pet.landed && motion != Motion::airborne;
    }
    if (screens_differ_) {
        follow_screen(id, pet, own);
    }
    pet.awake = pet.shown.mode != Mode::rest;
}

// Its motion begins anew, at the next start of its body.
void Engine::relaunch(Pet& pet, Vec2 velocity) {
    pet.shown.velocity = velocity;
    pet.body.launch(pet.position(), velocity, rules_, around(pet), wall_events());
    pet.started = false;
    if (pet.walk) {
        pet.walk->begun = false;
    } else if (pet.motion == Motion::walking) {
        pet.motion = motion_of(pet.body.mode());
        pet.since = now_;
    }
}

void Engine::meet(PetId id, Pet& pet, const TrajectoryEvent& event) {
    ++contacts_;
    const std::optional<Side> side = side_of(event.kind);
    if (!side) {
        return;
    }
    emit({.kind = EventKind::bounce, .pet = id, .side = *side, .speed = event.speed});
    if (*side == Side::bottom && !std::exchange(pet.landed, true)) {
        emit({.kind = EventKind::land, .pet = id, .speed = event.speed});
    }
}

EngineReport Engine::report() const {
    EngineReport report{
        .awake = awake_.size(), .asleep = size() - awake_.size(), .contacts = contacts_
    };
    const double lowest = arena_.bounds().bottom();
    pets_.for_each([&](PetId, const Pet& pet) {
        const Vec2 v = pet.velocity();
        const double height = lowest - box_of(pet).height - pet.position().y;
        report.energy += 0.5 * (v.x * v.x + v.y * v.y) + settings_.physics.gravity * height;
    });
    return report;
}

bool Engine::advance_held(Ticks time) {
    bool swinging = false;
    for (const Held& hand : held_) {
        Pet& pet = *pets_.find(hand.pet);
        const SpringBody body = hand.spring.at(time);
        const Vec2 off = body.position - hand.spring.target(time);
        pet.shown.position = body.position + hand.grown;
        pet.shown.velocity = body.velocity;
        if (screens_differ_) {
            follow_screen(hand.pet, pet, now_);
        }
        swinging = swinging || std::hypot(body.velocity.x, body.velocity.y) > still_speed ||
                   std::hypot(off.x, off.y) > still_distance;
    }
    return swinging;
}

}  // namespace hyrax
