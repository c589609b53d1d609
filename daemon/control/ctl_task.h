// SPDX-License-Identifier: MIT
// What hyraxctl does beyond one request and its answer.
#pragma once

#include "daemon/control/client.h"
#include "daemon/control/connection.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hyrax {

namespace task {
struct RunFile {
    std::filesystem::path file;
};
struct Repl {
    std::string script;  ///< Empty: one of its own, which lasts as long as it.
};
struct PluginNew {
    std::string id;
    std::filesystem::path into;
};
struct PluginCheck {
    std::filesystem::path folder;
};
struct PluginInstall {
    std::filesystem::path from;
    bool replace = false;
};
struct PluginRemove {
    std::string id;
    bool sure = false;  ///< Else the user is asked.
};
}  // namespace task

using CtlTask = std::variant<
    task::RunFile,
    task::Repl,
    task::PluginNew,
    task::PluginCheck,
    task::PluginInstall,
    task::PluginRemove>;

/// Tries a plugin, tells what is wrong with it, and returns the program's exit code.
using CheckPlugin = std::function<int(const std::filesystem::path& folder)>;

/// What a task may need.
struct TaskContext {
    ControlSystem& system;
    std::filesystem::path profile;
    CheckPlugin check_plugin;
    bool json = false;  ///< Answers for programs, where there are any.
};

/// Does it, tells what came of it on the terminal, and returns the program's exit code.
int perform(const CtlTask& task, const TaskContext& context);

// --- the parts; those about plugins are in plugin_task.cpp ---

int perform(const task::RunFile& task, const TaskContext& context);
int perform(const task::Repl& task, const TaskContext& context);
int perform(const task::PluginNew& task, const TaskContext& context);
int perform(const task::PluginCheck& task, const TaskContext& context);
int perform(const task::PluginInstall& task, const TaskContext& context);
int perform(const task::PluginRemove& task, const TaskContext& context);

/// Prints the error, and returns the exit code.
int told(const Error& error, int exit_code);

/// The requests that have the daemon run a script, to be sent one after the other. Fails for a text
/// that is no UTF-8.
[[nodiscard]] Result<std::vector<std::string>> run_requests(
    std::string_view name, std::string_view text
);

/// True for the error of a text that could go on.
bool is_unfinished(std::string_view error);

}  // namespace hyrax
