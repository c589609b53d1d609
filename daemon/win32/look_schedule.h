// SPDX-License-Identifier: MIT
// When to look at who is in front. Pure.
#pragma once

#include "physics/ticks.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace hyrax::win32 {

/// The system tells of a new front window before that has taken its place and size, and of some
/// changes not at all: so there is a look at once, two more, and one in each period.
class LookSchedule {
public:
    constexpr void hint(Ticks now) {
        hinted_at_ = now;
        next_ = 0;
    }
    /// `never`: no look without a hint.
    constexpr void set_period(Ticks period, Ticks now) {
        if (period != period_) {
            period_ = period;
            periodic_at_ = period == never ? never : now + period;
        }
    }
    constexpr Ticks due() const {
        const Ticks hinted = next_ < after_hint.size() ? hinted_at_ + after_hint[next_] : never;
        return std::min(hinted, periodic_at_);
    }
    constexpr void looked(Ticks now) {
        while (next_ < after_hint.size() && hinted_at_ + after_hint[next_] <= now) {
            ++next_;
        }
        periodic_at_ = period_ == never ? never : now + period_;
    }
    constexpr void stop() { *this = {}; }

private:
    static constexpr std::array<Ticks, 3> after_hint{0, 250 * ticks_per_ms, ticks_per_second};

    Ticks hinted_at_ = 0;
    std::size_t next_ = after_hint.size();
    Ticks period_ = never;
    Ticks periodic_at_ = never;
};

}  // namespace hyrax::win32
