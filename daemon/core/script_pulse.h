// SPDX-License-Identifier: MIT
// Signs of life of a script host, in memory that it shares with the daemon.
#pragma once

#include <atomic>
#include <cstdint>

namespace hyrax {

/// Written by the host, read by the daemon, which believes none of it more than it must: a wrong
/// pulse costs the host its life. Zero is where all begin.
struct ScriptPulse {
    std::atomic<std::uint64_t> beats;   ///< Work goes on: a call, some instructions, more memory.
    std::atomic<std::uint64_t> calls;   ///< Calls into scripts so far.
    std::atomic<std::uint32_t> script;  ///< 1 + place of the script that is running; 0: none.

    /// A call into the script at this place begins.
    void enter(std::uint32_t place) {
        script.store(place + 1, std::memory_order_relaxed);
        call();
    }
    /// The same script goes on with another call.
    void call() {
        count(calls);
        beat();
    }
    void leave() { script.store(0, std::memory_order_relaxed); }
    void beat() { count(beats); }

private:
    // Only the host writes, in one thread: no locked instruction is needed.
    static void count(std::atomic<std::uint64_t>& number) {
        number.store(number.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    }
};

static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

}  // namespace hyrax
