// SPDX-License-Identifier: MIT
#include "daemon/core/watchdog.h"

#include <algorithm>

namespace hyrax {

void Watchdog::start(Ticks now) {
    *this = {};
    last_look_ = now;
}

std::string_view Watchdog::look(const ScriptPulse& pulse, std::optional<Ticks> used, Ticks now) {
    Ticks passed = 0;
    if (used) {
        passed = *used - last_used_.value_or(*used);
        last_used_ = used;
    } else {
        const bool outside = pulse.script.load(std::memory_order_relaxed) == 0;
        passed = std::clamp<Ticks>(now - last_look_, 0, look_period) /
                 (outside ? wall_factor_outside : wall_factor);
    }
    last_look_ = now;

    const std::uint64_t beats = pulse.beats.load(std::memory_order_relaxed);
    const std::uint64_t calls = pulse.calls.load(std::memory_order_relaxed);
    silence_ = beats == beats_ ? silence_ + passed : 0;
    call_ = calls == calls_ ? call_ + passed : 0;
    beats_ = beats;
    calls_ = calls;
    if (silence_ > longest_silence) {
        return "gave no sign of life for 250 ms of processor time (a library call without an end?)";
    }
    if (call_ > longest_call) {
        return "used more than 3 s of processor time in one call";
    }
    return {};
}

}  // namespace hyrax
