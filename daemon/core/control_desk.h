// SPDX-License-Identifier: MIT
// Who of the control channel's clients hears of what. Without a port every call is free.
#pragma once

#include "daemon/core/control_port.h"
#include "daemon/core/desktop.h"
#include "daemon/core/event.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace hyrax {

class Daemon;
class Engine;

class ControlDesk {
public:
    /// So long scripts may take for an answer; hyraxctl waits a little longer.
    static constexpr Ticks patience = 4 * ticks_per_second;

    explicit ControlDesk(std::unique_ptr<ControlPort> port) : port_(std::move(port)) {}

    bool is_open() const { return port_ != nullptr; }
    void answer(Daemon& daemon, Desktop& desktop, const input::Asked& asked);
    void forget(Engine& engine, ClientId client);
    /// What has come of evaluations.
    void tell_evaluated(Daemon& daemon, Desktop& desktop, const std::vector<Evaluated>& evaluated);
    /// Scripts have not answered in time.
    void tell_late(Daemon& daemon, Desktop& desktop, Ticks now);
    /// When tell_late() has something to do, at the latest.
    Ticks due() const;
    /// Hands over what has happened since the last call.
    void tell_watchers(Engine& engine, Desktop& desktop, double seconds);

private:
    struct Watcher {
        ClientId client = 0;
        EventMask mask;
    };

    struct Waiting {
        ClientId client = 0;
        std::uint64_t evaluation = 0;
        Ticks until = 0;
    };

    void watch(Engine& engine) const;

    std::unique_ptr<ControlPort> port_;
    std::vector<Watcher> watchers_;
    std::vector<Waiting> waiting_;
};

}  // namespace hyrax
