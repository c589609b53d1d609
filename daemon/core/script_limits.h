// SPDX-License-Identifier: MIT
// What a script may use.
#pragma once

#include "daemon/core/script_pulse.h"

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace hyrax {

/// Of all scripts together, in one run: what a daemon can be bothered with.
inline constexpr std::size_t most_commands_in_all = 10'000;

/// What one script may use. Reaching a count is an ordinary error in the script, whose message
/// contains "limit"; reaching a budget ends the script. Every number must be positive.
struct ScriptLimits {
    std::size_t memory = std::size_t{16} << 20U;   ///< Heap of a script [bytes].
    std::size_t string = std::size_t{1} << 20U;    ///< Longest string [bytes].
    std::size_t source = std::size_t{1} << 20U;    ///< Longest source text [bytes].
    std::size_t chunk = std::size_t{64} << 10U;    ///< Longest text that load() takes [bytes].
    std::int64_t load_units = 20'000'000;          ///< Work units of a main chunk, about 50 ms.
    std::int64_t callback_units = 2'000'000;       ///< Work units of any other call, about 5 ms.
    std::int64_t unload_units = 200'000;           ///< Work units of all that "unload" calls.
    std::chrono::milliseconds load_time{1'000};    ///< Ends what the units undercount.
    std::chrono::milliseconds callback_time{250};  ///< The same for any other call.
    std::size_t pets = 64;                         ///< Own pets at one time.
    std::size_t timers = 256;
    std::size_t handlers = 256;    ///< Of hyrax.on and pet:on together.
    std::size_t waiting = 64;      ///< Coroutines in wait() or wait_for().
    std::size_t commands = 1'000;  ///< In one run.
    double max_speed = 20'000.0;   ///< Velocities are shortened to this [px/s].
    std::size_t name = 64;         ///< Longest kind or tag [bytes].
    std::size_t log_lines_per_second = 50;
    std::size_t log_burst = 100;                  ///< Lines after a silence.
    std::size_t log_line = 512;                   ///< [bytes]
    std::size_t store = std::size_t{256} << 10U;  ///< What hyrax.store holds [bytes].
    std::size_t speech = 200;                     ///< Longest text of say and notify [bytes].
    std::chrono::seconds notice_pause{30};        ///< Between two notices.
    std::uint64_t seed = 1;                       ///< Of math.random and of random places.
    /// Processor time of this thread or process; null: std::clock(), which Windows counts as time
    /// on the wall.
    std::chrono::nanoseconds (*processor_time)() = nullptr;
    ScriptPulse* pulse = nullptr;  ///< Where signs of life go; null: nowhere.
    bool operator==(const ScriptLimits&) const = default;
};

}  // namespace hyrax
