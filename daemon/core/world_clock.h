// SPDX-License-Identifier: MIT
// The time that pets and scripts live in: the machine's time without the pauses.
#pragma once

#include "physics/ticks.h"

namespace hyrax {

class WorldClock {
public:
    Ticks at(Ticks now) const { return (paused() ? paused_at_ : now) - lost_; }
    /// The machine's time at which the world's time will be `world`; `never` while paused.
    Ticks machine_time(Ticks world) const {
        return paused() || world >= never - lost_ ? never : world + lost_;
    }
    bool paused() const { return paused_at_ != never; }
    void set_paused(bool paused_now, Ticks now) {
        if (paused_now == paused()) {
            return;
        }
        if (paused_now) {
            paused_at_ = now;
        } else {
            lost_ += now - paused_at_;
            paused_at_ = never;
        }
    }

private:
    Ticks lost_ = 0;
    Ticks paused_at_ = never;
};

}  // namespace hyrax
