// SPDX-License-Identifier: MIT
// Who of the control channel's clients hears of what. Without a port every call is free.
#pragma once

#include "daemon/core/control_port.h"
#include "daemon/core/desktop.h"
#include "daemon/core/event.h"

#include <memory>
#include <utility>
#include <vector>

namespace hyrax {

class Daemon;
class Engine;

class ControlDesk {
public:
    explicit ControlDesk(std::unique_ptr<ControlPort> port) : port_(std::move(port)) {}

    bool is_open() const { return port_ != nullptr; }
    void answer(Daemon& daemon, Desktop& desktop, const input::Asked& asked);
    void forget(Engine& engine, ClientId client);
    /// Hands over what has happened since the last call.
    void tell_watchers(Engine& engine, Desktop& desktop, double seconds);

private:
    struct Watcher {
        ClientId client = 0;
        EventMask mask;
    };

    void watch(Engine& engine) const;

    std::unique_ptr<ControlPort> port_;
    std::vector<Watcher> watchers_;
};

}  // namespace hyrax
