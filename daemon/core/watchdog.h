// SPDX-License-Identifier: MIT
// Decides by its pulse when a script host hangs.
#pragma once

#include "daemon/core/script_pulse.h"
#include "physics/ticks.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace hyrax {

/// Counts the processor time of the process, so that neither a busy machine nor one that slept is
/// held against it. Where the system does not tell that, time on the wall counts, in small steps
/// and with a longer limit.
class Watchdog {
public:
    /// Without a beat: a library call that no count of instructions sees into.
    static constexpr Ticks longest_silence = 250 * ticks_per_ms;
    /// In one call that beats, which the limits inside the host should have ended long before.
    static constexpr Ticks longest_call = 3 * ticks_per_second;
    /// Both are so much longer on the wall,
    static constexpr int wall_factor = 4;
    /// and so much while no script runs: a process that starts on a busy machine takes its time.
    static constexpr int wall_factor_outside = 40;
    /// How often to look at least, and what one look counts at most on the wall.
    static constexpr Ticks look_period = 50 * ticks_per_ms;

    /// The host begins to work.
    void start(Ticks now);
    /// What is wrong; empty while nothing is. `used`: processor time of the process, if known.
    std::string_view look(const ScriptPulse& pulse, std::optional<Ticks> used, Ticks now);
    Ticks due() const { return last_look_ + look_period; }

private:
    Ticks last_look_ = 0;
    std::optional<Ticks> last_used_;
    std::uint64_t beats_ = 0;
    std::uint64_t calls_ = 0;
    Ticks silence_ = 0;
    Ticks call_ = 0;
};

}  // namespace hyrax
