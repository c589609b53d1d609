// SPDX-License-Identifier: MIT
// Who asks the daemon of one profile, again and again.
#pragma once

#include "daemon/control/connection.h"
#include "daemon/control/ctl_output.h"
#include "daemon/core/result.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace hyrax {

/// An answer, and the connection on which more of them may come.
struct Talk {
    std::unique_ptr<Connection> connection;
    std::string answer;
};

class Client {
public:
    /// `system` must outlive it.
    Client(ControlSystem& system, std::filesystem::path profile)
        : system_(system), profile_(std::move(profile)) {}

    [[nodiscard]] Result<Talk> ask(std::string_view request) const;

private:
    ControlSystem& system_;
    std::filesystem::path profile_;
};

}  // namespace hyrax
