// SPDX-License-Identifier: MIT
// One request over a connection, and its answers.
#pragma once

#include "daemon/control/connection.h"
#include "daemon/core/result.h"

#include <optional>
#include <string>
#include <string_view>

namespace hyrax {

class Conversation {
public:
    explicit Conversation(Connection& connection) : connection_(connection) {}

    [[nodiscard]] Result<void> ask(std::string_view request);
    /// The answer; fails when none comes within five seconds.
    [[nodiscard]] Result<std::string> answer();
    /// What comes after an answer, however late; nothing when the daemon has ended.
    [[nodiscard]] Result<std::optional<std::string>> more();

private:
    [[nodiscard]] Result<std::optional<std::string>> receive(
        std::optional<std::chrono::milliseconds> patience
    );

    Connection& connection_;
};

}  // namespace hyrax
