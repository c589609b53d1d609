// SPDX-License-Identifier: MIT
#include "daemon/control/plugin_setting.h"

#include "daemon/control/config_key.h"
#include "daemon/control/request_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace hyrax {
namespace {

std::unexpected<Refusal> refused(std::string message) {
    return std::unexpected(Refusal{"bad_request", "key: " + std::move(message)});
}

// What stands in config.json beside what the manifest declares.
SettingInForce enabled_of(const PluginEntry& entry, const PluginChoice& choice) {
    return {
        .key = fmt::format("{}{}.enabled", plugin_prefix, entry.id),
        .declared =
            {
                .key = "enabled",
                .type = SettingType::boolean,
                .default_value = {!entry.shipped},
                .label = "Whether it runs; what is chosen in the tray's menu comes before this.",
            },
        .value = {choice.enabled.value_or(!entry.shipped)},
    };
}

std::vector<SettingInForce> settings_of(const Daemon& daemon, const PluginEntry& entry) {
    const auto& choices = daemon.config().plugins;
    const auto found = choices.find(entry.id);
    const PluginChoice choice = found == choices.end() ? PluginChoice{} : found->second;
    std::vector<SettingInForce> settings{enabled_of(entry, choice)};
    for (const PluginSetting& setting : entry.plugin->settings) {
        settings.push_back({
            .key = fmt::format("{}{}.{}", plugin_prefix, entry.id, setting.key),
            .declared = setting,
            .value = value_in_force(setting, choice),
        });
    }
    return settings;
}

}  // namespace

std::vector<SettingInForce> plugin_settings(const Daemon& daemon) {
    std::vector<SettingInForce> all;
    for (const PluginEntry& entry : daemon.plugins()) {
        if (entry.plugin) {
            std::ranges::move(settings_of(daemon, entry), std::back_inserter(all));
        }
    }
    return all;
}

std::expected<SettingInForce, Refusal> find_plugin_setting(
    const Daemon& daemon, const std::string& key
) {
    const std::string names = key.substr(plugin_prefix.size());
    const std::string id = names.substr(0, names.find('.'));
    const std::vector<PluginEntry>& plugins = daemon.plugins();
    const auto entry = std::ranges::find(plugins, id, &PluginEntry::id);
    if (entry == plugins.end()) {
        std::vector<std::string_view> ids;
        for (const PluginEntry& plugin : plugins) {
            ids.emplace_back(plugin.id);
        }
        return refused(fmt::format("{}: {}", key, unknown_name(id, ids)));
    }
    if (!entry->plugin) {
        return refused(fmt::format("{}: the plugin cannot be read: {}", key, entry->problem));
    }
    const std::vector<SettingInForce> settings = settings_of(daemon, *entry);
    const auto found = std::ranges::find(settings, key, &SettingInForce::key);
    if (found == settings.end()) {
        std::vector<std::string_view> known;
        for (const SettingInForce& setting : settings) {
            known.emplace_back(setting.declared.key);
        }
        const std::string name = names.substr(std::min(names.size(), id.size() + 1));
        return refused(fmt::format("{}: {}", key, unknown_name(name, known)));
    }
    return *found;
}

}  // namespace hyrax
