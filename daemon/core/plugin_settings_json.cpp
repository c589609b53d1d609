// SPDX-License-Identifier: MIT
// The settings that plugin.json declares.
#include "daemon/core/plugin_fields_json.h"
#include "daemon/core/plugin_names.h"
#include "daemon/core/script_value_json.h"

#include <array>
#include <optional>
#include <utility>

namespace hyrax {
namespace {

// In the order of SettingType.
constexpr std::array<std::string_view, 4> type_names{"boolean", "integer", "number", "string"};

// A setting whose parts are still apart.
struct Declared {
    PluginSetting setting;
    std::optional<double> low;
    std::optional<double> high;
};

constexpr auto setting_fields = std::to_array<ManifestField<Declared>>({
    {"key",
     "string",
     true,
     "Its name in config.json and in hyrax.config.",
     [](const JsonValue& value, Declared& d) {
         read_text(
             value,
             d.setting.key,
             is_setting_key,
             "must be 1 to 64 small letters, digits and _, a letter first, and not \"enabled\""
         );
     }},
    {"type",
     "string",
     true,
     "What values it takes.",
     [](const JsonValue& value, Declared& d) {
         if (const auto name = value.choice(type_names)) {
             const auto found = std::ranges::find(type_names, *name);
             d.setting.type = static_cast<SettingType>(found - type_names.begin());
         }
     }},
    {"default", "", true, "Its value until the user says otherwise.", nullptr},
    {"min",
     "number",
     false,
     "The least number.",
     [](const JsonValue& value, Declared& d) { d.low = value.number(-most_setting, most_setting); }
    },
    {"max",
     "number",
     false,
     "The largest number.",
     [](const JsonValue& value, Declared& d) { d.high = value.number(-most_setting, most_setting); }
    },
    {"choices",
     "array",
     false,
     "The texts that a string may be; without it: any.",
     [](const JsonValue& value, Declared& d) {
         for (const JsonValue& item :
              value.items(1, most_manifest_items).value_or(std::vector<JsonValue>{})) {
             read_line(item, d.setting.choices.emplace_back());
         }
     }},
    {"label",
     "string",
     false,
     "What it is, for people.",
     [](const JsonValue& value, Declared& d) { read_line(value, d.setting.label); }},
});

void finish_range(const JsonValue& value, Declared& declared) {
    PluginSetting& setting = declared.setting;
    const bool numeric =
        setting.type == SettingType::integer || setting.type == SettingType::number;
    for (const std::string_view bound : {"min", "max"}) {
        if (const auto given = value.member(bound); given && !numeric) {
            given->error_at_key("only a number has it");
        }
    }
    if (const auto given = value.member("choices"); given && setting.type != SettingType::string) {
        given->error_at_key("only a string has it");
    }
    setting.low = declared.low.value_or(-most_setting);
    setting.high = declared.high.value_or(most_setting);
    if (setting.low > setting.high) {
        value.member("min")->expected("must not be above max");
        std::swap(setting.low, setting.high);
    }
}

}  // namespace

void read_settings(const JsonValue& value, Plugin& plugin) {
    for (const JsonValue& item :
         value.items(0, most_manifest_items).value_or(std::vector<JsonValue>{})) {
        Declared declared;
        if (!read_fields<Declared>(item, setting_fields, declared)) {
            continue;
        }
        finish_range(item, declared);
        const JsonValue given = *item.member("default");
        Result<ScriptValue> value_of_it =
            fitted(declared.setting, script_value_from(given.located().value));
        if (value_of_it) {
            declared.setting.default_value = *std::move(value_of_it);
        } else {
            given.expected(value_of_it.error().message);
        }
        if (std::ranges::count(plugin.settings, declared.setting.key, &PluginSetting::key) != 0) {
            item.member("key")->expected("must be a key that no other setting has");
        }
        plugin.settings.push_back(std::move(declared.setting));
    }
}

void describe_settings(std::vector<PluginField>& list) {
    describe<Declared>("/config/*", setting_fields, list);
}

}  // namespace hyrax
