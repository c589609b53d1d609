// SPDX-License-Identifier: MIT
// The other end of a ScriptChannel: what a script host's process has of the daemon.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace hyrax {

/// The first argument of a program that is started to be a script host. Nobody types it.
inline constexpr std::string_view script_host_switch = "--script-host";

/// The host's end of the wire. Both calls wait.
class ScriptLink {
public:
    ScriptLink() = default;
    ScriptLink(const ScriptLink&) = delete;
    ScriptLink& operator=(const ScriptLink&) = delete;
    virtual ~ScriptLink() = default;

    /// Puts what has come into the front of `into`; 0: the daemon is gone.
    virtual std::size_t read(std::span<std::byte> into) = 0;
    /// False: the daemon is gone.
    virtual bool write(std::span<const std::byte> bytes) = 0;
};

/// What a script host's process ends with.
inline constexpr int host_exit_ok = 0;              ///< The daemon has gone or wants no more.
inline constexpr int host_exit_not_understood = 3;  ///< A broken message.
inline constexpr int host_exit_out_of_memory = 4;

}  // namespace hyrax
