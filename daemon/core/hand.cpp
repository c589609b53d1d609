// SPDX-License-Identifier: MIT
#include "daemon/core/hand.h"

#include <cstdlib>

namespace hyrax {
namespace {

constexpr Ticks click_time = 400 * ticks_per_ms;
constexpr int click_slop = 4;  // [px], the system's default for a drag

}  // namespace

void Hand::take(PetId pet, Vec2 grip, Point at, Ticks time) {
    pet_ = pet;
    grip_ = grip;
    at_ = at;
    taken_at_ = at;
    taken_time_ = time;
    moved_ = false;
}

bool Hand::move(Point at) {
    if (at == at_) {
        return false;
    }
    at_ = at;
    moved_ = moved_ || std::abs(at.x - taken_at_.x) > click_slop ||
             std::abs(at.y - taken_at_.y) > click_slop;
    return true;
}

Vec2 Hand::carried_to() const {
    return Vec2{static_cast<double>(at_.x), static_cast<double>(at_.y)} + grip_;
}

bool Hand::was_click(Ticks now) const {
    return !moved_ && now - taken_time_ <= click_time;
}

}  // namespace hyrax
