// SPDX-License-Identifier: MIT
// Reads plugin.json by the table of its fields.
#include "daemon/core/file_name.h"
#include "daemon/core/plugin_fields_json.h"
#include "daemon/core/plugin_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace hyrax {
namespace {

constexpr int manifest_version = 1;
constexpr std::size_t longest_line = 100;
constexpr std::size_t longest_text = 500;

constexpr std::array<std::string_view, 2> reload_names{"keep", "remove"};

// Nothing outside the folder, and nothing that Windows takes for something else.
std::optional<std::string> file_in_folder(const JsonValue& value, std::string_view ending) {
    const std::string what = fmt::format("must be a file in this folder that ends in {}", ending);
    const std::string* const text = text_in(value);
    if (text == nullptr) {
        value.expected(what);
        return std::nullopt;
    }
    std::optional<std::string> path = value.relative_path();
    if (!path) {
        return path;
    }
    bool fits = path->ends_with(ending);
    for (std::string_view rest = *path; !rest.empty();) {
        const std::string_view part = take_part(rest, '/');
        fits = fits && !names_device(part) && !part.ends_with('.') && !part.ends_with(' ');
    }
    if (!fits) {
        value.expected(what);
        return std::nullopt;
    }
    return path;
}

void read_manifest(const JsonValue& value, Plugin& /*plugin*/) {
    value.whole_number(manifest_version, manifest_version);
}

void read_id(const JsonValue& value, Plugin& plugin) {
    read_text(
        value,
        plugin.id,
        is_plugin_id,
        "must be 3 to 40 small letters, digits and inner hyphens, such as \"rock-concert\""
    );
}

void read_api(const JsonValue& value, Plugin& plugin) {
    const std::string* const text = text_in(value);
    std::string_view minor;
    if (text != nullptr) {
        minor = *text;
    }
    const bool same_major = take_part(minor, '.') == std::to_string(script_api_major);
    if (!same_major || !is_count(minor) || std::stoi(std::string(minor)) > script_api_minor) {
        value.expected(fmt::format(
            "must be a version of hyrax.api, \"{}.{}\" at most and of the same first number",
            script_api_major,
            script_api_minor
        ));
        return;
    }
    plugin.api = *text;
}

void read_permissions(const JsonValue& value, Plugin& plugin) {
    for (const JsonValue& item :
         value.items(0, most_manifest_items).value_or(std::vector<JsonValue>{})) {
        if (std::optional<std::string> permission = item.choice(script_permissions)) {
            plugin.permissions.push_back(*std::move(permission));
        }
    }
    std::ranges::sort(plugin.permissions);
    const auto repeated = std::ranges::unique(plugin.permissions);
    plugin.permissions.erase(repeated.begin(), repeated.end());
}

void read_kinds(const JsonValue& value, Plugin& plugin) {
    if (!value.is_object()) {
        return;
    }
    if (value.children().size() > most_manifest_items) {
        value.error(fmt::format(
            "must be at most {} kinds, got {}", most_manifest_items, value.children().size()
        ));
        return;
    }
    for (const JsonValue& each : value.children()) {
        if (!is_kind_name(each.located().key)) {
            each.error_at_key("a kind's name must be 1 to 23 small letters, digits, - and _");
            continue;
        }
        if (auto file = file_in_folder(each, "sprite.json")) {
            plugin.kinds.push_back({each.located().key, *std::move(file)});
        }
    }
}

constexpr auto manifest_fields = std::to_array<ManifestField<Plugin>>({
    {"$schema",
     "string",
     false,
     "The schema by which an editor explains and completes this file.",
     nullptr},
    {"manifest", "integer", true, "The version of this file's format: 1.", read_manifest},
    {"id",
     "string",
     true,
     "The plugin's name for programs, and that of its folder: 3 to 40 small letters, digits and "
     "inner hyphens.",
     read_id},
    {"version",
     "string",
     true,
     "Of the plugin, as semver.org has it.",
     [](const JsonValue& value, Plugin& p) {
         read_text(
             value,
             p.version,
             is_version,
             "must be a version as semver.org has it, such as \"1.2.0\""
         );
     }},
    {"api", "string", true, "The version of hyrax.api that it needs.", read_api},
    {"name",
     "string",
     true,
     "The plugin's name for people.",
     [](const JsonValue& value, Plugin& p) { read_line(value, p.name); }},
    {"description",
     "string",
     false,
     "What it does, in a sentence.",
     [](const JsonValue& value, Plugin& p) {
         read_text(
             value,
             p.description,
             [](std::string_view text) { return is_line(text, longest_text); },
             "must be a text of 1 to 500 bytes in one line"
         );
     }},
    {"author",
     "string",
     false,
     "Who made it.",
     [](const JsonValue& value, Plugin& p) { read_line(value, p.author); }},
    {"license",
     "string",
     false,
     "Its licence, as spdx.org names it.",
     [](const JsonValue& value, Plugin& p) { read_line(value, p.license); }},
    {"entry",
     "string",
     false,
     "The Lua file that runs first.",
     [](const JsonValue& value, Plugin& p) {
         p.entry = file_in_folder(value, ".lua").value_or(p.entry);
     }},
    {"permissions",
     "array",
     false,
     "What it needs beyond its own pets. The user is asked once.",
     read_permissions},
    {"kinds",
     "object",
     false,
     "Its own kinds of pets: for each name a sprite.json in this folder.",
     read_kinds},
    {"config",
     "array",
     false,
     "The settings that the user may change in config.json under plugins.",
     read_settings},
    {"on_reload",
     "string",
     false,
     "What becomes of its pets when it is loaded again: they stay, or go.",
     [](const JsonValue& value, Plugin& p) {
         p.keep_pets = value.choice(reload_names).value_or("") != reload_names[1];
     }},
});

}  // namespace

const std::string* text_in(const JsonValue& value) {
    return value.located().value.get_ptr<const std::string*>();
}

void read_text(
    const JsonValue& value, std::string& slot, bool (*fits)(std::string_view), std::string_view what
) {
    const std::string* const text = text_in(value);
    if (text != nullptr && fits(*text)) {
        slot = *text;
    } else {
        value.expected(what);
    }
}

void read_line(const JsonValue& value, std::string& slot) {
    read_text(
        value,
        slot,
        [](std::string_view text) { return is_line(text, longest_line); },
        "must be a text of 1 to 100 bytes in one line"
    );
}

Result<Plugin> parse_plugin(
    std::string_view text, std::string_view file, std::vector<std::string>& warnings
) {
    const Result<LocatedJson> root = parse_located_json(text, file);
    if (!root) {
        return std::unexpected(root.error());
    }
    JsonProblems problems{std::string(file)};
    Plugin plugin;
    read_fields<Plugin>(JsonValue(*root, "", problems), manifest_fields, plugin);
    if (problems.has_errors()) {
        return std::unexpected(problems.error());
    }
    for (std::string& warning : problems.warnings()) {
        warnings.push_back(std::move(warning));
    }
    return plugin;
}

std::vector<PluginField> plugin_fields() {
    std::vector<PluginField> list;
    describe<Plugin>("", manifest_fields, list);
    describe_settings(list);
    return list;
}

}  // namespace hyrax
