// SPDX-License-Identifier: MIT
#include "daemon/core/topmost.h"

#include <algorithm>

namespace hyrax {

namespace {

constexpr Ticks retry_after = 250 * ticks_per_ms;
constexpr Ticks period = ticks_per_second;
constexpr std::size_t most_lost = 3;
constexpr Ticks fight = 5 * ticks_per_second;
constexpr Ticks truce = 60 * ticks_per_second;

}  // namespace

bool reaches_taskbars(const Frame& frame, std::span<const Monitor> monitors) {
    return std::ranges::any_of(monitors, [&](const Monitor& monitor) {
        return std::ranges::any_of(frame.sprites, [&](const Sprite& sprite) {
            const Rect seen = intersection(sprite.bounds(), monitor.bounds);
            return !seen.empty() && !monitor.work.contains(seen);
        });
    });
}

void TopmostKeeper::hint(Ticks now) {
    hinted_at_ = now;
    retried_ = false;
}

void TopmostKeeper::set_exposed(bool exposed, Ticks now) {
    if (exposed != (exposed_at_ != never)) {
        exposed_at_ = exposed ? now : never;
    }
}

Ticks TopmostKeeper::due() const {
    return std::min(hinted_at_, exposed_at_);
}

bool TopmostKeeper::check(Sight sight, Ticks now) {
    if (now >= hinted_at_) {
        hinted_at_ = retried_ ? never : now + retry_after;
        retried_ = true;
    }
    if (now >= exposed_at_) {
        exposed_at_ = now + period;
    }
    if (!sight.buried || sight.flyout_in_front || now < truce_until_) {
        return false;
    }
    if (raised_at_ != never && now - raised_at_ <= fight) {
        lost_.push_back(now);
    }
    while (!lost_.empty() && now - lost_.front() > fight) {
        lost_.pop_front();
    }
    raised_at_ = now;
    if (lost_.size() >= most_lost) {
        lost_.clear();
        raised_at_ = never;
        truce_until_ = now + truce;
        return false;
    }
    return true;
}

}  // namespace hyrax
