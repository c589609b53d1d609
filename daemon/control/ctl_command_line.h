// SPDX-License-Identifier: MIT
// The options of hyraxctl, made from the table of verbs.
#pragma once

#include "daemon/control/command_line.h"
#include "daemon/control/ctl_task.h"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace hyrax {

struct CtlCommandLine {
    std::string request;  ///< JSON, checked; empty where there is a task.
    std::optional<CtlTask> task;
    bool stays = false;  ///< More answers will come.
    bool json = false;   ///< Answers for programs.
    std::optional<std::filesystem::path> profile;
};

inline constexpr int exit_ok = 0;
inline constexpr int exit_refused = 1;
inline constexpr int exit_usage = 2;
inline constexpr int exit_no_daemon = 3;

/// Arguments without the program's name, UTF-8.
std::variant<CtlCommandLine, Farewell> parse_ctl_arguments(const std::vector<std::string>& arguments
);

/// The words that complete a command line in bash or PowerShell; empty for another shell.
std::string completion_script(std::string_view shell);

/// docs/control.md
std::string control_manual();

}  // namespace hyrax
