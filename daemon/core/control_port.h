// SPDX-License-Identifier: MIT
// The door between the daemon and the control channel: texts come in, texts go out. What they mean
// is known in control/ alone.
#pragma once

#include "daemon/core/event.h"
#include "daemon/core/script_port.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hyrax {

class Daemon;
class Engine;

struct ControlAnswer {
    std::string text;
    std::optional<EventMask> watch{};  ///< The client stays and hears of these events.
    /// Instead of the text: what comes of this evaluation.
    std::optional<std::uint64_t> evaluation{};
};

/// Answers the clients of the control channel, between two frames and on the daemon's thread.
class ControlPort {
public:
    ControlPort() = default;
    ControlPort(const ControlPort&) = delete;
    ControlPort& operator=(const ControlPort&) = delete;
    virtual ~ControlPort() = default;

    /// Any text at all, valid or not. `watchers`: clients that hear of events already.
    virtual ControlAnswer answer(
        Daemon& daemon, std::string_view request, std::size_t watchers
    ) = 0;
    /// The answer for a client that waits for an evaluation; called once for each.
    virtual std::string evaluated(Daemon& daemon, const Evaluated& evaluated) = 0;
    /// An event for those who watch; `seconds` since the start.
    virtual std::string told(const Engine& engine, const Event& event, double seconds) = 0;
};

}  // namespace hyrax
