// SPDX-License-Identifier: MIT
#include "daemon/control/ctl_task_command_line.h"

#include "daemon/core/files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hyrax {

CLI::App* subcommand_of(CLI::App& app, const std::string& name) {
    const std::vector<CLI::App*> found =
        app.get_subcommands([&name](const CLI::App* each) { return each->get_name() == name; });
    return found.empty() ? nullptr : found.front();
}

Farewell wrong_usage(std::string_view where, std::string_view message) {
    return {
        fmt::format("hyraxctl: {}{}{}\n", where, where.empty() ? "" : ": ", message), exit_usage
    };
}

TaskCommands::TaskCommands(CLI::App& app, CtlCommandLine& line)
    : line_(line),
      run_(subcommand_of(app, "run")),
      repl_(app.add_subcommand(
          "repl", "Runs Lua line by line in a script. Only if scripts.developer is true."
      )) {
    CLI::Option* const file =
        run_->add_option("file", run_file_, "The script's file")->type_name("");
    run_->add_option("--stop", run_stop_, "Ends the script of this name instead")
        ->type_name("NAME")
        ->excludes(file);
    repl_->add_option("script", repl_script_, "Which one; left out, one of its own")->type_name("");
    repl_->footer("Example: hyraxctl repl fountain.lua");
    add_plugin_commands(app);
}

void TaskCommands::add_plugin_commands(CLI::App& app) {
    CLI::App* const plugin =
        app.add_subcommand("plugin", "Makes, checks, installs and removes plugins.");
    plugin->require_subcommand(1);
    new_ = plugin->add_subcommand("new", "Makes a folder with a plugin that works.");
    new_->add_option("id", plugin_, "Small letters, digits and hyphens")->required()->type_name("");
    new_->add_option(
            "--into", into_, "The folder in which its own one is made; this one if left out"
    )
        ->type_name("FOLDER");
    new_->footer("Example: hyraxctl plugin new catch-me");
    check_ = plugin->add_subcommand(
        "check", "Reads a plugin and runs it for a minute of its own time; needs no hyrax."
    );
    check_->add_option("folder", plugin_, "The plugin's folder")->required()->type_name("");
    check_->footer("Example: hyraxctl plugin check catch-me");
    install_ = plugin->add_subcommand("install", "Puts a copy of a plugin into the profile.");
    install_->add_option("from", plugin_, "The plugin's folder or zip file")
        ->required()
        ->type_name("");
    install_->add_flag("--replace", replace_, "In the place of the one that is there");
    install_->footer("Example: hyraxctl plugin install catch-me.zip");
    remove_ = plugin->add_subcommand("remove", "Removes a plugin's folder from the profile.");
    remove_->add_option("id", plugin_, "The plugin's id")->required()->type_name("");
    remove_->add_flag("--yes", sure_, "Do not ask");
    remove_->footer("Example: hyraxctl plugin remove catch-me");
}

std::optional<Farewell> TaskCommands::finish() {
    if (run_->parsed()) {
        if (run_file_.empty() == run_stop_.empty()) {
            return wrong_usage("run", "a file is needed, or --stop NAME");
        }
        if (run_stop_.empty()) {
            line_.task = task::RunFile{path_from_utf8(run_file_)};
        } else {
            line_.request =
                nlohmann::ordered_json{{"do", "run"}, {"name", run_stop_}, {"stop", true}}.dump();
        }
    }
    if (repl_->parsed()) {
        line_.task = task::Repl{repl_script_};
    }
    if (new_->parsed()) {
        line_.task = task::PluginNew{plugin_, path_from_utf8(into_)};
    } else if (check_->parsed()) {
        line_.task = task::PluginCheck{path_from_utf8(plugin_)};
    } else if (install_->parsed()) {
        line_.task = task::PluginInstall{path_from_utf8(plugin_), replace_};
    } else if (remove_->parsed()) {
        line_.task = task::PluginRemove{plugin_, sure_};
    }
    return std::nullopt;
}

}  // namespace hyrax
