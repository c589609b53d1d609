// SPDX-License-Identifier: MIT
// Settings of plugins as commands name them: "plugins.catch.balls" for /plugins/catch/balls in
// config.json.
#pragma once

#include "daemon/control/verb.h"
#include "daemon/core/daemon.h"
#include "daemon/core/plugin.h"
#include "daemon/core/script_value.h"

#include <expected>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

/// What a plugin declares, and the value that holds.
struct SettingInForce {
    std::string key;  ///< "plugins.catch.balls"
    PluginSetting declared;
    ScriptValue value;
};

/// Those of all plugins that can be read, `enabled` first.
std::vector<SettingInForce> plugin_settings(const Daemon& daemon);

/// The one with this key, dotted. A refusal names the nearest plugin or setting.
std::expected<SettingInForce, Refusal> find_plugin_setting(
    const Daemon& daemon, const std::string& key
);

}  // namespace hyrax
