// SPDX-License-Identifier: MIT
// The options of hyrax.exe and hyrax-headless.
#pragma once

#include "daemon/core/request.h"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace hyrax {

/// Instead of running: print this and end.
struct Farewell {
    std::string text;
    int exit_code = 0;  ///< 0 after --help and --version, 2 after a wrong option.
};

/// What both programs take.
struct CommonOptions {
    std::vector<Request> requests;  ///< In the order in which they were given.
    std::optional<std::filesystem::path> trace;
    bool for_testing =
        false;  ///< A broken check aborts; pets without a place come in a fixed order.
};

struct DaemonCommandLine {
    CommonOptions common;
    std::optional<std::filesystem::path> profile;  ///< Instead of the user's own folder.
};

struct HeadlessCommandLine {
    CommonOptions common;
    std::optional<std::filesystem::path> config;
    std::vector<std::filesystem::path> scripts;
    double seconds = 10.0;  ///< Virtual, 0 to 1e6.
    std::optional<double> fps;
    std::string monitors = "1920x1080+0+0";
    std::optional<std::filesystem::path> snapshot;
    bool script_process = false;  ///< Scripts run in a process of their own.
};

/// Arguments without the program's name, UTF-8.
std::variant<DaemonCommandLine, Farewell> parse_daemon_arguments(
    const std::vector<std::string>& arguments
);
std::variant<HeadlessCommandLine, Farewell> parse_headless_arguments(
    const std::vector<std::string>& arguments
);

}  // namespace hyrax
