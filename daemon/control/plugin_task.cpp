// SPDX-License-Identifier: MIT
// hyraxctl plugin.
#include "daemon/control/ctl_command_line.h"
#include "daemon/control/ctl_task.h"
#include "daemon/control/plugin_folder.h"
#include "daemon/core/files.h"

#include <fmt/format.h>

#include <cstdio>

namespace hyrax {

int perform(const task::PluginNew& task, const TaskContext&) {
    const Result<std::filesystem::path> folder = new_plugin(task.id, task.into);
    if (!folder) {
        return told(folder.error(), exit_refused);
    }
    fmt::print("{}\n", utf8_from_path(*folder));
    return exit_ok;
}

int perform(const task::PluginCheck& task, const TaskContext& context) {
    return context.check_plugin(task.folder);
}

int perform(const task::PluginInstall& task, const TaskContext& context) {
    const Result<Plugin> plugin = install_plugin(task.from, context.profile, task.replace);
    if (!plugin) {
        return told(plugin.error(), exit_refused);
    }
    fmt::print("{} {} in {}\n", plugin->id, plugin->version, utf8_from_path(plugin->folder));
    if (!plugin->permissions.empty()) {
        fmt::print("it asks for: {}\n", fmt::join(plugin->permissions, ", "));
    }
    return exit_ok;
}

int perform(const task::PluginRemove& task, const TaskContext& context) {
    if (!task.sure) {
        fmt::print("Remove {}, its folder and all that is in it? [y/N] ", task.id);
        std::fflush(stdout);
        const std::optional<std::string> answer = context.system.read_line();
        if (answer != "y" && answer != "Y" && answer != "yes") {
            return told({"nothing was removed"}, exit_refused);
        }
    }
    if (const Result<void> removed = remove_plugin(task.id, context.profile); !removed) {
        return told(removed.error(), exit_refused);
    }
    return exit_ok;
}

}  // namespace hyrax
