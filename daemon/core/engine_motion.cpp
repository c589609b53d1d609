// SPDX-License-Identifier: MIT
// The frame: one step of the document's law for every pet that is awake, and the rule of rest.
#include "daemon/core/engine.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyrax {
namespace {

// A frame never moves a pet by more than this: after a hitch the pets go on, they do not leap.
constexpr Ticks longest_step = 100 * ticks_per_ms;

// The document's law never comes to rest at 60 Hz: the vertical velocity cycles between 0 and
// -12 px/s while the position stays on the floor (docs/physics.md). Three frames in a row on the
// floor tell that cycle from a bounce, which leaves the floor in the next frame.
constexpr int frames_until_settled = 3;

// Slower than this a settled pet stands still [px/s]: below a tenth of a pixel a frame at 60 Hz.
constexpr double stop_speed = 5.0;

}  // namespace

void Engine::advance(Ticks now) {
    now_ = now;
    // Steps may put pets to sleep, never wake others, so one pass compacts the list in place.
    std::erase_if(awake_, [this, now](PetId id) {
        Pet& pet = *pets_.find(id);
        if (pet.stepped_at) {
            step(id, pet, to_seconds(std::min(now - *pet.stepped_at, longest_step)));
        }
        pet.stepped_at = now;
        return !pet.awake;
    });
}

void Engine::step(PetId id, Pet& pet, double dt) {
    const Size size = box_of(pet);
    const PhysicsConstants& law = settings_.physics;
    // What the law makes of the velocity before it meets anything: the speed of an impact.
    const double arriving_x = pet.body.vx() * law.air_drag;
    const double arriving_y = (pet.body.vy() + law.gravity * dt) * law.air_drag;
    // A pet wider or higher than its box is pinned: the law alone would flicker between two places.
    const int width = std::max(pet.home.width, size.width);
    const int height = std::max(pet.home.height, size.height);
    pet.body.update(dt, width, height, size.width, size.height);

    const auto bounce = [this, id](Side side, double speed) {
        emit({.kind = EventKind::bounce, .pet = id, .side = side, .speed = std::fabs(speed)});
    };
    const double right = width - size.width;
    const double bottom = height - size.height;
    if (pet.body.x() == 0.0 && arriving_x < 0.0) {
        bounce(Side::left, arriving_x);
    } else if (pet.body.x() == right && arriving_x > 0.0) {
        bounce(Side::right, arriving_x);
    }
    if (pet.body.y() == 0.0 && arriving_y < 0.0) {
        bounce(Side::top, arriving_y);
    }

    if (pet.body.y() == bottom && pet.body.vy() <= 0.0) {
        ++pet.frames_on_floor;
        if (pet.frames_on_floor == 1 && arriving_y > 0.0) {
            bounce(Side::bottom, arriving_y);
            if (!std::exchange(pet.landed, true)) {
                emit({.kind = EventKind::land, .pet = id, .speed = arriving_y});
            }
        }
    } else {
        pet.frames_on_floor = 0;
    }
    if (std::fabs(pet.body.vx()) > stop_speed) {
        pet.faces_left = pet.body.vx() < 0.0;
    }
    rest_if_still(pet);
}

void Engine::rest_if_still(Pet& pet) {
    const PhysicsConstants& law = settings_.physics;
    const double speed = std::hypot(pet.body.vx(), pet.body.vy());
    const bool floats_still =
        law.gravity == 0.0 && (speed == 0.0 || (law.air_drag < 1.0 && speed < stop_speed));
    const bool settled = pet.frames_on_floor >= frames_until_settled || floats_still;

    if (settled != (pet.motion == Motion::settled)) {
        pet.motion = settled ? Motion::settled : Motion::airborne;
        pet.since = now_;
        pet.landed = pet.landed && settled;
    }
    if (settled && std::fabs(pet.body.vx()) < stop_speed) {
        pet.body.resetVelocity();
        pet.awake = false;
    }
}

}  // namespace hyrax
