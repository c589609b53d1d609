// SPDX-License-Identifier: MIT
// Objects of plugin.json, read by a table of their fields. Only for plugin_*.cpp.
#pragma once

#include "daemon/core/checked_json.h"
#include "daemon/core/plugin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

/// In any list of a manifest.
inline constexpr std::size_t most_manifest_items = 64;

template <typename Target>
struct ManifestField {
    std::string_view name;
    std::string_view type;
    bool required;
    std::string_view description;
    /// Null: somebody else does.
    void (*read)(const JsonValue&, Target&);
};

/// The string there, or null.
const std::string* text_in(const JsonValue& value);
/// Sets the slot, or tells that the value `must be ...`.
void read_text(
    const JsonValue& value, std::string& slot, bool (*fits)(std::string_view), std::string_view what
);
/// The same for a text of 1 to 100 bytes in one line.
void read_line(const JsonValue& value, std::string& slot);
/// /config
void read_settings(const JsonValue& value, Plugin& plugin);
/// Appends the fields of a setting.
void describe_settings(std::vector<PluginField>& list);

template <typename Target>
std::vector<std::string_view> names_of(std::span<const ManifestField<Target>> fields) {
    std::vector<std::string_view> names;
    for (const ManifestField<Target>& field : fields) {
        names.push_back(field.name);
    }
    return names;
}

/// False, with an error, if a field is missing.
template <typename Target>
bool read_fields(
    const JsonValue& object, std::span<const ManifestField<Target>> fields, Target& target
) {
    if (!object.is_object()) {
        return false;
    }
    const std::vector<std::string_view> known = names_of(fields);
    for (const JsonValue& member : object.children()) {
        const auto field =
            std::ranges::find(fields, member.located().key, &ManifestField<Target>::name);
        if (field == fields.end()) {
            member.warn_of_unknown_key(known);
        } else if (field->read != nullptr) {
            field->read(member, target);
        }
    }
    bool complete = true;
    for (const ManifestField<Target>& field : fields) {
        complete = (!field.required || object.required(field.name)) && complete;
    }
    return complete;
}

template <typename Target>
void describe(
    std::string_view prefix,
    std::span<const ManifestField<Target>> fields,
    std::vector<PluginField>& list
) {
    for (const ManifestField<Target>& field : fields) {
        list.push_back(
            {.path = fmt::format("{}/{}", prefix, field.name),
             .type = field.type,
             .required = field.required,
             .description = field.description}
        );
    }
}

}  // namespace hyrax
