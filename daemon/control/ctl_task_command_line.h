// SPDX-License-Identifier: MIT
// The part of hyraxctl's command line that is not made from the table of verbs.
#pragma once

#include "daemon/control/ctl_command_line.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace hyrax {

/// Null if the application has no such command.
CLI::App* subcommand_of(CLI::App& app, const std::string& name);
/// `where` may be empty.
Farewell wrong_usage(std::string_view where, std::string_view message);

/// Adds the commands to an application that has those of the verbs.
class TaskCommands {
public:
    /// Both must outlive it, and it must stay where it is.
    TaskCommands(CLI::App& app, CtlCommandLine& line);
    TaskCommands(const TaskCommands&) = delete;
    TaskCommands& operator=(const TaskCommands&) = delete;

    /// After parsing: writes what was chosen into the line. An answer means that it was wrong.
    std::optional<Farewell> finish();

private:
    void add_plugin_commands(CLI::App& app);

    CtlCommandLine& line_;
    CLI::App* run_ = nullptr;
    std::string run_file_;
    std::string run_stop_;
    CLI::App* repl_ = nullptr;
    std::string repl_script_;
    CLI::App* new_ = nullptr;
    CLI::App* check_ = nullptr;
    CLI::App* install_ = nullptr;
    CLI::App* remove_ = nullptr;
    std::string plugin_;  // Its id, folder or file.
    std::string into_ = ".";
    bool replace_ = false;
    bool sure_ = false;
};

}  // namespace hyrax
