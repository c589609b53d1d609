// SPDX-License-Identifier: MIT
// The verbs about config.json.
#include "daemon/control/config_edit.h"
#include "daemon/control/config_key.h"
#include "daemon/control/plugin_setting.h"
#include "daemon/control/verb.h"
#include "daemon/core/files.h"
#include "daemon/core/script_value_json.h"
#include "daemon/core/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace hyrax {
namespace {

using json = nlohmann::ordered_json;

constexpr std::size_t max_file_bytes = 1U << 20U;
constexpr std::size_t longest_shown = 60;  // Of a value in a message.

json short_form(const ConfigField& field) {
    return {
        {"key", dotted(field.path)},
        {"value", json::parse(field.default_value)},
        {"unit", field.unit},
    };
}

json long_form(const ConfigField& field) {
    json form = short_form(field);
    form["type"] = field.type;
    if (!field.choices.empty()) {
        form["choices"] = field.choices;
    } else if (field.type != "string") {
        form["low"] = field.low;
        form["high"] = field.high;
    }
    form["description"] = field.description;
    return form;
}

json short_form(const SettingInForce& setting) {
    return {{"key", setting.key}, {"value", json(json_from(setting.value))}, {"unit", ""}};
}

std::string_view type_name(SettingType type) {
    constexpr std::array<std::string_view, 4> names{"boolean", "integer", "number", "string"};
    return names[static_cast<std::size_t>(type)];
}

json long_form(const SettingInForce& setting) {
    const PluginSetting& declared = setting.declared;
    json form = short_form(setting);
    form["type"] = type_name(declared.type);
    if (!declared.choices.empty()) {
        form["choices"] = declared.choices;
    }
    if (declared.low > -most_setting) {
        form["low"] = declared.low;
    }
    if (declared.high < most_setting) {
        form["high"] = declared.high;
    }
    form["default"] = json(json_from(declared.default_value));
    form["description"] = declared.label;
    return form;
}

Outcome get(VerbContext& context, const json& arguments) {
    const std::vector<ConfigField> values = settable(config_values(context.daemon.config()));
    if (arguments.contains("key")) {
        const std::string path = pointer_of(arguments["key"].get<std::string>());
        if (dotted(path).starts_with(plugin_prefix)) {
            const auto setting = find_plugin_setting(context.daemon, dotted(path));
            return setting ? Outcome(long_form(*setting)) : std::unexpected(setting.error());
        }
        return long_form(*std::ranges::find(values, path, &ConfigField::path));
    }
    json settings = json::array();
    for (const ConfigField& field : values) {
        settings.push_back(short_form(field));
    }
    for (const SettingInForce& setting : plugin_settings(context.daemon)) {
        settings.push_back(short_form(setting));
    }
    return json{{"settings", std::move(settings)}};
}

// As its plugin's manifest wants it; other keys are left to parse_config().
Outcome checked_value(const Daemon& daemon, const std::string& pointer, const json& value) {
    if (!dotted(pointer).starts_with(plugin_prefix)) {
        return value;
    }
    const auto setting = find_plugin_setting(daemon, dotted(pointer));
    if (!setting) {
        return std::unexpected(setting.error());
    }
    const Result<ScriptValue> fit = fitted(setting->declared, script_value_from(value));
    if (!fit) {
        return std::unexpected(Refusal{
            "bad_value",
            fmt::format(
                "not written: {}: {}, got {}",
                setting->key,
                fit.error().message,
                shortened(value.dump(), longest_shown)
            ),
        });
    }
    return json(json_from(*fit));
}

Outcome set(VerbContext& context, const json& arguments) {
    const std::filesystem::path& path = context.daemon.profile().config;
    const std::string file = utf8_from_path(path);
    const Result<std::string> text = read_text_file(path, max_file_bytes);
    if (!text) {
        return std::unexpected(Refusal{"refused", text.error().message});
    }
    const std::string pointer = pointer_of(arguments["key"].get<std::string>());
    const Outcome value = checked_value(context.daemon, pointer, arguments["value"]);
    if (!value) {
        return value;
    }
    const Result<std::string> changed = with_value(*text, pointer, value->dump(), file);
    if (!changed) {
        return std::unexpected(Refusal{"refused", changed.error().message});
    }
    // The whole file, so that nothing is written that the daemon would not read.
    const Result<LoadedConfig> loaded = parse_config(*changed, file);
    if (!loaded) {
        return std::unexpected(Refusal{"bad_value", "not written: " + loaded.error().message});
    }
    if (const Result<void> saved = context.save(path, *changed); !saved) {
        return std::unexpected(Refusal{std::string(not_saved), saved.error().message});
    }
    context.daemon.handle(input::FilesChanged{});
    return json{{"key", dotted(pointer)}, {"value", *value}};
}

constexpr std::array get_parameters{
    Parameter{
        .name = "key",
        .type = ParameterType::key,
        .help = "This one alone, with its range and meaning.",
        .positional = true,
    },
};

constexpr std::array set_parameters{
    Parameter{
        .name = "key",
        .type = ParameterType::key,
        .help = "Which setting.",
        .required = true,
        .positional = true,
    },
    Parameter{
        .name = "value",
        .type = ParameterType::json,
        .help = "Its new value; a list as JSON.",
        .required = true,
        .positional = true,
    },
};

constexpr std::array table{
    Verb{
        "config get",
        "Shows settings as they hold now.",
        get_parameters,
        "config get physics.gravity",
        get
    },
    Verb{
        "config set",
        "Writes a setting into config.json, whose comments and other values stay as they are. "
        "Refused, and nothing is written, if the file would have a mistake.",
        set_parameters,
        "config set physics.gravity 300",
        set
    },
};

}  // namespace

std::span<const Verb> config_verbs() {
    return table;
}

}  // namespace hyrax
