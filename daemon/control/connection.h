// SPDX-License-Identifier: MIT
// A client's end of the control channel, and what else hyraxctl needs of its system. The build
// picks the room that defines it.
#pragma once

#include "daemon/core/image.h"
#include "daemon/core/result.h"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

class Connection {
public:
    Connection() = default;
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    virtual ~Connection() = default;

    [[nodiscard]] virtual Result<void> write(std::string_view bytes) = 0;
    /// Waits for bytes and takes at most `most`; none when the daemon has closed its end. Without
    /// patience it waits for ever.
    [[nodiscard]] virtual Result<std::string> read(
        std::size_t most, std::optional<std::chrono::milliseconds> patience
    ) = 0;
};

class ControlSystem {
public:
    ControlSystem() = default;
    ControlSystem(const ControlSystem&) = delete;
    ControlSystem& operator=(const ControlSystem&) = delete;
    virtual ~ControlSystem() = default;

    /// The folder of what comes with the program.
    virtual std::filesystem::path shipped() = 0;
    /// How sprite sheets are read. It must not outlive this object.
    virtual ImageDecoder decoder() = 0;
    /// True while a person types.
    virtual bool is_interactive() = 0;
    /// The next line of the standard input in UTF-8, without its end; nothing at the end of it.
    virtual std::optional<std::string> read_line() = 0;
    /// UTF-8, the program's name left out.
    virtual std::vector<std::string> arguments() = 0;
    /// The folder that the daemon uses if nothing else is said.
    [[nodiscard]] virtual Result<std::filesystem::path> usual_profile() = 0;
    /// To the profile's daemon, which has been seen to be this user's own. The error says why not.
    [[nodiscard]] virtual Result<std::unique_ptr<Connection>> connect(
        const std::filesystem::path& profile
    ) = 0;
};

/// Of main(). `argc` and `argv` are those of main.
[[nodiscard]] std::unique_ptr<ControlSystem> make_control_system(int argc, char** argv);

}  // namespace hyrax
