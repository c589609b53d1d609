// SPDX-License-Identifier: MIT
// The plugins that a profile has: which of them run, and what is wrong with the others.
#pragma once

#include "daemon/core/plugin.h"
#include "daemon/core/plugin_choice.h"
#include "daemon/core/profile.h"
#include "daemon/core/remembered.h"
#include "daemon/core/script_port.h"
#include "daemon/core/sprite_set.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

enum class PluginState { on, off, asks, broken };

/// "on", "off", "asks" or "broken".
std::string_view name_of(PluginState state);

/// A plugin of the profile.
struct PluginEntry {
    std::string id;                  ///< The name of its folder.
    std::optional<Plugin> plugin{};  ///< The last that could be read; none: it never could.
    std::string problem{};           ///< Why it cannot be read now; empty: it can.
    bool shipped = false;            ///< Off until somebody turns it on.
    bool wanted_anyway = false;      ///< Named on the command line: it runs, with all it asks for.
    PluginState state = PluginState::off;
    std::vector<std::string> missing{};  ///< Permissions that it asks for and does not have.
};

/// Every folder of user/plugins and shipped/scripts/plugins, by name; the user's comes before a
/// shipped one. Folders among `more_scripts` come last. Who cannot be read keeps what `before` has
/// of it. Appends warnings of manifests that have changed since.
std::vector<PluginEntry> find_plugins(
    const Profile& profile,
    const std::vector<PluginEntry>& before,
    std::vector<std::string>& warnings
);

using PluginChoices = std::map<std::string, PluginChoice>;

/// Sets `state` and `missing`. What was chosen in the menu comes before the config.
void judge(
    std::vector<PluginEntry>& plugins, const PluginChoices& choices, const Remembered& remembered
);

/// The plugin's sets, "<id>/<kind>", in its own order. Those fail for which most_plugin_pixels, or
/// what other sets have left of most_sheet_pixels, leaves no room.
std::vector<ReadKind> load_plugin_kinds(
    const Plugin& plugin, const ImageDecoder& decode, std::size_t room = most_sheet_pixels
);

/// What the setting is: the value that the choice gives it, where that fits, else its default.
ScriptValue value_in_force(const PluginSetting& setting, const PluginChoice& choice);

/// The script of a plugin that can be read, without its store. Settings that the plugin does not
/// know, or that do not fit, are told in `problems`; then the default holds.
ScriptSource source_of(
    const Plugin& plugin, const PluginChoice& choice, std::vector<std::string>& problems
);

/// What is wrong: broken folders, and choices for plugins that are not there.
std::vector<std::string> problems_of(
    const std::vector<PluginEntry>& plugins, const PluginChoices& choices
);

/// "weather asks for: wind (tray menu: Plugins, or hyraxctl plugins allow weather)" for each that
/// asks, joined; empty: none.
std::string asking_text(const std::vector<PluginEntry>& plugins);

/// Changes when the files of these sets do.
std::string stamp_of_kinds(const std::vector<PluginEntry>& plugins);

}  // namespace hyrax
