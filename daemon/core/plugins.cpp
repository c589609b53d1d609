// SPDX-License-Identifier: MIT
#include "daemon/core/plugins.h"

#include "daemon/core/files.h"
#include "daemon/core/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <system_error>
#include <type_traits>
#include <utility>
#include <variant>

namespace hyrax {
namespace {

namespace fs = std::filesystem;

using Folders = std::map<std::string, fs::path>;

// Folders that hold a manifest, by name; a name that is there already stays.
void find_folders(const fs::path& root, Folders& found) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(root, error)) {
        std::error_code unreadable;
        if (fs::exists(entry.path() / plugin_manifest_name, unreadable)) {
            found.emplace(utf8_from_path(entry.path().filename()), entry.path());
        }
    }
}

PluginEntry read_entry(
    const std::string& id,
    const fs::path& folder,
    const std::vector<PluginEntry>& before,
    std::vector<std::string>& warnings
) {
    PluginEntry entry{.id = id};
    std::vector<std::string> odd;
    Result<Plugin> plugin = read_plugin(folder, odd);
    if (plugin && plugin->id != id) {
        plugin = failure(fmt::format(
            "{}: /id: must be the name of its folder, \"{}\", got \"{}\"",
            utf8_from_path(folder / plugin_manifest_name),
            id,
            plugin->id
        ));
    }
    const auto old = std::ranges::find(before, id, &PluginEntry::id);
    if (!plugin) {
        entry.problem = std::move(plugin.error().message);
        // What another folder held is not this one's.
        if (old != before.end() && old->plugin && old->plugin->folder == folder) {
            entry.plugin = old->plugin;
        }
        return entry;
    }
    if (old == before.end() || !old->plugin || old->plugin->warnings != odd) {
        std::ranges::copy(odd, std::back_inserter(warnings));
    }
    entry.plugin = *std::move(plugin);
    entry.plugin->warnings = std::move(odd);
    return entry;
}

std::string whole_name(const Plugin& plugin, const PluginKind& kind) {
    return plugin.id + "/" + kind.name;
}

fs::path folder_of(const Plugin& plugin, const PluginKind& kind) {
    return (plugin.folder / path_from_utf8(kind.file)).parent_path();
}

std::string shown(const ScriptValue& value) {
    const auto text = [](const auto& held) -> std::string {
        using Held = std::remove_cvref_t<decltype(held)>;
        if constexpr (std::is_same_v<Held, std::string>) {
            return fmt::format("\"{}\"", held);
        } else if constexpr (std::is_arithmetic_v<Held>) {
            return fmt::format("{}", held);
        } else {
            return "nothing";
        }
    };
    return std::visit(text, value.data);
}

void tell_wrong_settings(
    const Plugin& plugin, const PluginChoice& choice, std::vector<std::string>& problems
) {
    std::vector<std::string_view> known{"enabled"};
    for (const PluginSetting& setting : plugin.settings) {
        known.emplace_back(setting.key);
    }
    for (const GivenSetting& given : choice.settings) {
        const std::string where =
            fmt::format("{}: /plugins/{}/{}", given.place, plugin.id, given.key);
        const auto setting = std::ranges::find(plugin.settings, given.key, &PluginSetting::key);
        if (setting == plugin.settings.end()) {
            const auto nearest = nearest_name(given.key, known);
            problems.push_back(fmt::format(
                "{}: the plugin has no such setting{}",
                where,
                nearest ? fmt::format("; did you mean \"{}\"?", *nearest) : ""
            ));
        } else if (const Result<ScriptValue> value = fitted(*setting, given.value); !value) {
            problems.push_back(fmt::format(
                "{}: {}, got {}; the default {} is used",
                where,
                value.error().message,
                given.found,
                shown(setting->default_value)
            ));
        }
    }
}

bool is_wanted(
    const PluginEntry& entry, const PluginChoices& choices, const Remembered& remembered
) {
    if (const auto chosen = remembered.plugins.find(entry.id); chosen != remembered.plugins.end()) {
        return chosen->second;
    }
    const auto choice = choices.find(entry.id);
    const bool said = choice != choices.end() && choice->second.enabled.has_value();
    return said ? *choice->second.enabled : !entry.shipped;
}

}  // namespace

std::string_view name_of(PluginState state) {
    constexpr std::array<std::string_view, 4> names{"on", "off", "asks", "broken"};
    return names[static_cast<std::size_t>(state)];
}

std::vector<PluginEntry> find_plugins(
    const Profile& profile,
    const std::vector<PluginEntry>& before,
    std::vector<std::string>& warnings
) {
    Folders folders;
    find_folders(profile.user / "plugins", folders);
    const Folders own = folders;
    find_folders(profile.shipped / "scripts" / "plugins", folders);
    Folders named;
    for (const fs::path& path : profile.more_scripts) {
        std::error_code error;
        if (const fs::path real = fs::canonical(path, error); fs::is_directory(real, error)) {
            named.insert_or_assign(utf8_from_path(real.filename()), real);
        }
    }
    std::vector<PluginEntry> plugins;
    for (const auto& [id, folder] : folders) {
        if (!named.contains(id)) {
            plugins.push_back(read_entry(id, folder, before, warnings));
            plugins.back().shipped = !own.contains(id);
        }
    }
    for (const auto& [id, folder] : named) {
        plugins.push_back(read_entry(id, folder, before, warnings));
        plugins.back().wanted_anyway = true;
    }
    return plugins;
}

void judge(
    std::vector<PluginEntry>& plugins, const PluginChoices& choices, const Remembered& remembered
) {
    for (PluginEntry& entry : plugins) {
        entry.missing.clear();
        if (!entry.plugin) {
            entry.state = PluginState::broken;
            continue;
        }
        const auto granted = remembered.granted.find(entry.id);
        for (const std::string& permission : entry.plugin->permissions) {
            if (!entry.wanted_anyway && (granted == remembered.granted.end() ||
                                         std::ranges::count(granted->second, permission) == 0)) {
                entry.missing.push_back(permission);
            }
        }
        const bool wanted = entry.wanted_anyway || is_wanted(entry, choices, remembered);
        entry.state = !wanted                 ? PluginState::off
                      : entry.missing.empty() ? PluginState::on
                                              : PluginState::asks;
    }
}

std::vector<ReadKind> load_plugin_kinds(
    const Plugin& plugin, const ImageDecoder& decode, std::size_t room
) {
    std::vector<ReadKind> kinds;
    std::size_t pixels = 0;
    for (const PluginKind& kind : plugin.kinds) {
        Result<SpriteSet> set =
            load_sprite_set(folder_of(plugin, kind), decode, room - std::min(room, pixels));
        if (set) {
            set->name = whole_name(plugin, kind);
            pixels += set->sheet.pixels.size();
        }
        if (set && pixels > most_plugin_pixels) {
            set = failure(fmt::format(
                "{}: /kinds/{}: the pictures up to this one have {} pixels; those of a plugin have "
                "at most {}",
                utf8_from_path(plugin.folder / plugin_manifest_name),
                kind.name,
                pixels,
                most_plugin_pixels
            ));
        }
        kinds.push_back({whole_name(plugin, kind), std::move(set)});
        if (pixels > most_plugin_pixels) {
            break;
        }
    }
    return kinds;
}

ScriptValue value_in_force(const PluginSetting& setting, const PluginChoice& choice) {
    const auto given = std::ranges::find(choice.settings, setting.key, &GivenSetting::key);
    return given == choice.settings.end()
               ? setting.default_value
               : fitted(setting, given->value).value_or(setting.default_value);
}

ScriptSource source_of(
    const Plugin& plugin, const PluginChoice& choice, std::vector<std::string>& problems
) {
    ScriptSource source{
        .name = plugin.id,
        .text = plugin.text,
        .version = plugin.version,
        .file = plugin.entry,
        .modules = plugin.modules,
        .permissions = plugin.permissions,
        .keep_pets = plugin.keep_pets,
    };
    for (const PluginSetting& setting : plugin.settings) {
        set_field(source.config, setting.key, value_in_force(setting, choice));
    }
    tell_wrong_settings(plugin, choice, problems);
    return source;
}

std::vector<std::string> problems_of(
    const std::vector<PluginEntry>& plugins, const PluginChoices& choices
) {
    std::vector<std::string> problems;
    for (const PluginEntry& entry : plugins) {
        if (!entry.problem.empty()) {
            problems.push_back(entry.problem);
        }
    }
    for (const auto& [id, choice] : choices) {
        if (std::ranges::count(plugins, id, &PluginEntry::id) == 0) {
            problems.push_back(fmt::format("config.json: /plugins/{}: there is no such plugin", id)
            );
        }
    }
    return problems;
}

std::string asking_text(const std::vector<PluginEntry>& plugins) {
    std::string text;
    for (const PluginEntry& entry : plugins) {
        if (entry.state == PluginState::asks) {
            text += fmt::format(
                "{}{} asks for: {} (tray menu: Plugins, or hyraxctl plugins allow {})",
                text.empty() ? "plugin " : "; ",
                entry.id,
                fmt::join(entry.missing, ", "),
                entry.id
            );
        }
    }
    return text;
}

std::string stamp_of_kinds(const std::vector<PluginEntry>& plugins) {
    std::string stamp;
    for (const PluginEntry& entry : plugins) {
        if (entry.state != PluginState::on) {
            continue;
        }
        for (const PluginKind& kind : entry.plugin->kinds) {
            stamp +=
                whole_name(*entry.plugin, kind) + stamp_of_folder(folder_of(*entry.plugin, kind));
        }
    }
    return stamp;
}

}  // namespace hyrax
