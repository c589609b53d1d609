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
    std::optional<std::filesystem::path> statistics;  ///< Gets lines of append_statistics().
    bool for_testing =
        false;  ///< A broken check aborts; pets without a place come in a fixed order.
};

struct DaemonCommandLine {
    CommonOptions common;
    std::optional<std::filesystem::path> profile;  ///< Instead of the user's own folder.
    bool autostart = false;  ///< Started by the session: a second such start asks for nothing.
};

struct HeadlessCommandLine {
    CommonOptions common;
    std::optional<std::filesystem::path> config;
    std::vector<std::filesystem::path> scripts;
    /// 0 to 1e6, of the clock it runs on.
    std::optional<double> seconds;
    /// If nothing is said: without end if it serves, 3600 for tests, which end by themselves,
    /// or 10.
    double duration() const;
    bool real_time = false;  ///< Else the clock is virtual.
    bool serve = false;      ///< On the real clock, with a control channel.
    std::optional<double> fps;
    std::string monitors = "1920x1080+0+0";
    std::optional<std::filesystem::path> windows;
    std::optional<std::filesystem::path> snapshot;
    bool script_process = false;                 ///< Scripts run in a process of their own.
    std::optional<std::filesystem::path> test;   ///< A script whose cases run, alone.
    std::optional<std::filesystem::path> state;  ///< Holds what scripts keep.
};

/// Arguments without the program's name, UTF-8.
std::variant<DaemonCommandLine, Farewell> parse_daemon_arguments(
    const std::vector<std::string>& arguments
);
std::variant<HeadlessCommandLine, Farewell> parse_headless_arguments(
    const std::vector<std::string>& arguments
);

}  // namespace hyrax
