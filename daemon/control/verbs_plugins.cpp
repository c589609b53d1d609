// SPDX-License-Identifier: MIT
// The verb about plugins.
#include "daemon/control/verb.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

namespace hyrax {
namespace {

using json = nlohmann::ordered_json;

json list_of(const Daemon& daemon) {
    json list = json::array();
    for (const PluginEntry& entry : daemon.plugins()) {
        json item{{"id", entry.id}, {"state", name_of(entry.state)}};
        if (entry.plugin) {
            item["name"] = entry.plugin->name;
            item["version"] = entry.plugin->version;
            item["permissions"] = entry.plugin->permissions;
            item["missing"] = entry.missing;
        }
        add_use(item, daemon.pets_of(entry.id), daemon.use_of(entry.id));
        item["error"] = entry.problem.empty() ? daemon.error_of(entry.id) : entry.problem;
        list.push_back(std::move(item));
    }
    return json{{"plugins", std::move(list)}};
}

Outcome plugins(VerbContext& context, const json& arguments) {
    if (!arguments.contains("act")) {
        return list_of(context.daemon);
    }
    const auto act = arguments["act"].get<std::string>();
    if (act != "allow" && act != "deny") {
        return std::unexpected(Refusal{
            "bad_request",
            fmt::format("plugins: act: must be \"allow\" or \"deny\", got \"{}\"", act)
        });
    }
    if (!arguments.contains("plugin")) {
        return std::unexpected(
            Refusal{"bad_request", fmt::format("plugins {}: plugin: its id is missing", act)}
        );
    }
    const auto id = arguments["plugin"].get<std::string>();
    const auto& known = context.daemon.plugins();
    if (std::ranges::count(known, id, &PluginEntry::id) == 0) {
        return std::unexpected(
            Refusal{"no_such_plugin", fmt::format("there is no plugin \"{}\"", id)}
        );
    }
    context.daemon.handle(Request{request::AllowPlugin{id, act == "allow"}});
    const auto now = std::ranges::find(known, id, &PluginEntry::id);
    return json{{"plugin", id}, {"state", name_of(now->state)}};
}

constexpr std::array plugins_parameters{
    Parameter{
        .name = "act",
        .help = "allow: grants the plugin what it asks for, and turns it on. deny: takes it back, "
                "and turns it off. Without it: shows all plugins.",
        .positional = true,
    },
    Parameter{.name = "plugin", .help = "Its id.", .positional = true},
};

constexpr std::array table{
    Verb{
        "plugins",
        "Shows the plugins, what they may, what they use and what is wrong with them; allows or "
        "denies one what "
        "it asks for.",
        plugins_parameters,
        "plugins allow weather",
        plugins
    },
};

}  // namespace

std::span<const Verb> plugin_verbs() {
    return table;
}

}  // namespace hyrax
