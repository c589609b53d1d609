// SPDX-License-Identifier: MIT
// Settings as commands name them: "physics.gravity" for /physics/gravity in config.json.
#pragma once

#include "daemon/core/config.h"

#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

/// "/physics/gravity" from either form.
std::string pointer_of(std::string_view key);
/// "physics.gravity" from "/physics/gravity".
std::string dotted(std::string_view pointer);

/// How keys begin that are settings of plugins; only a daemon knows which there are.
inline constexpr std::string_view plugin_prefix = "plugins.";

/// Those that a command can name: no items of lists, and nothing that only editors read.
std::vector<ConfigField> settable(std::vector<ConfigField> fields);
/// The names of all of them, dotted.
std::vector<std::string> settable_keys();

}  // namespace hyrax
