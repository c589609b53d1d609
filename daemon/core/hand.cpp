// SPDX-License-Identifier: MIT
#include "daemon/core/hand.h"

#include <cmath>
#include <cstdlib>

namespace hyrax {
namespace {

constexpr Ticks window = 100 * ticks_per_ms;
constexpr Ticks still_after = 80 * ticks_per_ms;
constexpr Ticks click_time = 400 * ticks_per_ms;
constexpr int click_slop = 4;  // [px], the system's default for a drag

}  // namespace

void Hand::take(PetId pet, Vec2 grip, Point at, Ticks time) {
    pet_ = pet;
    grip_ = grip;
    taken_ = {at, time};
    moved_ = false;
    samples_.assign(1, taken_);
}

void Hand::move(Point at, Ticks time) {
    if (at == samples_.back().at) {
        return;
    }
    moved_ = moved_ || std::abs(at.x - taken_.at.x) > click_slop ||
             std::abs(at.y - taken_.at.y) > click_slop;
    samples_.push_back({at, time});
    std::erase_if(samples_, [time](const Sample& sample) { return time - sample.time > window; });
}

Vec2 Hand::carried_to() const {
    const Point at = samples_.back().at;
    return Vec2{static_cast<double>(at.x), static_cast<double>(at.y)} + grip_;
}

Vec2 Hand::throw_velocity(Ticks now, double limit) const {
    if (samples_.size() < 2 || now - samples_.back().time > still_after) {
        return {};
    }
    // Least squares: sum((t - mean t)(x - mean x)) / sum((t - mean t)^2). Times and places are
    // taken relative to the newest sample, so that the sums keep their digits.
    const Sample& newest = samples_.back();
    const auto count = static_cast<double>(samples_.size());
    double t_sum = 0.0;
    Vec2 place_sum;
    for (const Sample& sample : samples_) {
        t_sum += to_seconds(sample.time - newest.time);
        place_sum.x += sample.at.x - newest.at.x;
        place_sum.y += sample.at.y - newest.at.y;
    }
    double spread = 0.0;
    Vec2 slope;
    for (const Sample& sample : samples_) {
        const double t = to_seconds(sample.time - newest.time) - t_sum / count;
        spread += t * t;
        slope.x += t * (sample.at.x - newest.at.x - place_sum.x / count);
        slope.y += t * (sample.at.y - newest.at.y - place_sum.y / count);
    }
    if (spread <= 0.0) {
        return {};
    }
    const Vec2 velocity = slope * (1.0 / spread);
    const double speed = std::hypot(velocity.x, velocity.y);
    return speed > limit ? velocity * (limit / speed) : velocity;
}

bool Hand::was_click(Ticks now) const {
    return !moved_ && now - taken_.time <= click_time;
}

}  // namespace hyrax
