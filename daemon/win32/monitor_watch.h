// SPDX-License-Identifier: MIT
// Decides when a change of screens is real. Pure: readings come in, a verdict comes out.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/win32/debounce.h"
#include "physics/ticks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace hyrax::win32 {

/// One change of screens raises many messages, and reads back half-done states: none at all while
/// the secure desktop shows, or the old sizes. So a reading counts when it was seen twice.
class MonitorWatch {
public:
    explicit MonitorWatch(std::vector<Monitor> at_start, Ticks now)
        : current_(std::move(at_start)) {
        if (current_.empty()) {
            again_at_ = now + retry_after;
        }
    }

    /// The system says that something may have changed.
    void hint(Ticks now) {
        hints_.hint(now);
        again_at_ = never;
        candidate_.clear();
    }
    /// The machine has slept.
    void woke_up(Ticks now) {
        hint(now);
        look_later(now);
    }
    /// When to read the monitors and call `settle`; `never` while nothing happens.
    Ticks due() const {
        const Ticks look =
            next_look_ < later_looks.size() ? looks_since_ + later_looks[next_look_] : never;
        return std::min({hints_.due(), again_at_, look});
    }

    /// Takes a reading that was due. True when the monitors have changed.
    bool settle(std::vector<Monitor> reading, Ticks now) {
        hints_.take(now);
        again_at_ = never;
        while (next_look_ < later_looks.size() && looks_since_ + later_looks[next_look_] <= now) {
            ++next_look_;
        }
        if (reading.empty()) {
            again_at_ = now + retry_after;
            return false;
        }
        if (reading == current_) {
            candidate_.clear();
            return false;
        }
        if (candidate_ != reading) {
            candidate_ = std::move(reading);
            again_at_ = now + confirm_after;
            return false;
        }
        current_ = std::exchange(candidate_, {});
        look_later(now);
        return true;
    }

    const std::vector<Monitor>& current() const { return current_; }

private:
    static constexpr Ticks confirm_after = 150 * ticks_per_ms;
    static constexpr Ticks retry_after = ticks_per_second;
    static constexpr std::array<Ticks, 3> later_looks{
        ticks_per_second, 5 * ticks_per_second, 10 * ticks_per_second
    };

    /// Screens come and go one by one, seconds apart, and not each of them is told of.
    void look_later(Ticks now) {
        looks_since_ = now;
        next_look_ = 0;
    }

    std::vector<Monitor> current_;
    std::vector<Monitor> candidate_;  ///< Seen once; empty if none.
    Debounce hints_{300 * ticks_per_ms, 2 * ticks_per_second};
    Ticks again_at_ = never;
    Ticks looks_since_ = 0;
    std::size_t next_look_ = later_looks.size();
};

}  // namespace hyrax::win32
