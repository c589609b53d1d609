// SPDX-License-Identifier: MIT
// A plugin: a folder with plugin.json, Lua and sprite sets, read and checked as a whole.
#pragma once

#include "daemon/core/result.h"
#include "daemon/core/script_port.h"
#include "daemon/core/script_value.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

inline constexpr std::string_view plugin_manifest_name = "plugin.json";

/// What one folder may hold; names that begin with a dot do not count.
inline constexpr std::size_t most_plugin_files = 200;
inline constexpr std::size_t most_plugin_bytes = std::size_t{32} << 20U;
/// Of all Lua files together.
inline constexpr std::size_t most_plugin_source = std::size_t{1} << 20U;

/// A side of its pictures [px].
inline constexpr int most_plugin_side = 4096;
/// Of all its pictures together, as its kinds use them: 64 MiB once decoded.
inline constexpr std::size_t most_plugin_pixels = std::size_t{4096} * 4096;

/// The largest number that a setting may have: whole ones up to here are exact.
inline constexpr double most_setting = 9e15;

enum class SettingType { boolean, integer, number, string };

/// A setting that the user may change in config.json under /plugins/<id>/<key>.
struct PluginSetting {
    std::string key;
    SettingType type = SettingType::boolean;
    double low = -most_setting;  ///< Of a number.
    double high = most_setting;
    std::vector<std::string> choices{};  ///< Of a string; empty: any.
    ScriptValue default_value{};
    std::string label{};
};

/// The value as the setting wants it: whole numbers become numbers and 3.0 a whole number, where
/// that is asked for. The message of a failure is what is expected: "must be true or false".
[[nodiscard]] Result<ScriptValue> fitted(const PluginSetting& setting, const ScriptValue& value);

/// A sprite set of a plugin. Everybody else calls it "<id>/<name>".
struct PluginKind {
    std::string name;
    std::string file;  ///< "sprites/rocker/sprite.json", relative to the plugin's folder.
};

/// What a manifest says, and the texts beside it.
struct Plugin {
    std::filesystem::path folder{};
    std::string id{};
    std::string version{};
    std::string api{};  ///< "1.0"
    std::string name{};
    std::string description{};
    std::string author{};
    std::string license{};
    std::string entry = "main.lua";
    std::vector<std::string> permissions{};  ///< Of script_permissions, sorted, each once.
    std::vector<PluginKind> kinds{};
    std::vector<PluginSetting> settings{};
    bool keep_pets = true;  ///< Over a reload.

    std::string text{};                   ///< Of the entry.
    std::vector<ScriptModule> modules{};  ///< The other Lua files, sorted by name.
    std::vector<std::string> warnings{};  ///< Of whoever read it: read_plugin() leaves it empty.
};

/// 3 to 40 small letters, digits and inner hyphens; no device, and not "user", who owns pets.
bool is_plugin_id(std::string_view text);

/// Reads <folder>/plugin.json, the Lua files and what they weigh, and checks all of it; of
/// pictures, only the size that their headers tell. A failure has a line for each error, which
/// begins with the file and, in the manifest, the line and the column. Appends what is odd to
/// `warnings`. Nothing is run.
[[nodiscard]] Result<Plugin> read_plugin(
    const std::filesystem::path& folder, std::vector<std::string>& warnings
);

/// The manifest alone; `file` names it in messages.
[[nodiscard]] Result<Plugin> parse_plugin(
    std::string_view text, std::string_view file, std::vector<std::string>& warnings
);

/// One field of plugin.json, as it is read; config/plugin.schema.json tells editors the same.
struct PluginField {
    std::string path;       ///< JSON pointer, in which * stands for each item of a list.
    std::string_view type;  ///< As JSON Schema names it; empty: several.
    bool required = false;
    std::string_view description;
};

/// Every field that parse_plugin() knows.
std::vector<PluginField> plugin_fields();

}  // namespace hyrax
