// SPDX-License-Identifier: MIT
// The seam between the daemon and the process in which scripts run.
#pragma once

#include "daemon/core/result.h"
#include "daemon/core/script_pulse.h"
#include "physics/ticks.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hyrax {

/// A script host's process and the wire to it. At most one lives at a time. No call but
/// wait() waits for it.
class ScriptChannel {
public:
    /// How a process ended.
    struct End {
        bool crashed = false;  ///< By its own doing, and not because somebody ended it.
        std::string how;       ///< "signal 11"
    };

    ScriptChannel() = default;
    ScriptChannel(const ScriptChannel&) = delete;
    ScriptChannel& operator=(const ScriptChannel&) = delete;
    virtual ~ScriptChannel() = default;

    /// Starts a fresh process; the one before must have ended.
    [[nodiscard]] virtual Result<void> start() = 0;
    /// Sends all of it, as fast as the process reads; what it does not read is kept.
    virtual void send(std::span<const std::byte> bytes) = 0;
    /// Appends what has come.
    virtual void receive(std::vector<std::byte>& bytes) = 0;
    /// Set once the process has ended; what it said before may still be received.
    virtual std::optional<End> ended() = 0;
    /// Waits until there is something to receive or the process has ended, at most so long, and
    /// sends meanwhile. False without a process.
    virtual bool wait(std::chrono::milliseconds patience) = 0;
    /// Ends the process, whatever it does. Nothing is received from it afterwards.
    virtual void kill() = 0;

    /// Of the process; all zero while none lives.
    virtual const ScriptPulse& pulse() const = 0;
    /// Processor time of the process so far; nothing where the system does not tell it.
    virtual std::optional<Ticks> processor_time() = 0;
};

}  // namespace hyrax
