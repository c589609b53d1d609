// SPDX-License-Identifier: MIT
#include "daemon/core/script_value_json.h"

#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace hyrax {
namespace {

using nlohmann::json;

constexpr int deepest = 32;

ScriptTable table_from(const json& object, int depth);

// Deeper than any store that was written is taken for nothing.
ScriptValue value_from(const json& value, int depth) {
    if (depth > deepest) {
        return {};
    }
    switch (value.type()) {
        case json::value_t::boolean:
            return {value.get<bool>()};
        case json::value_t::number_integer:
            return {value.get<std::int64_t>()};
        case json::value_t::number_unsigned: {
            const auto number = value.get<std::uint64_t>();
            return number <= std::uint64_t{INT64_MAX}
                       ? ScriptValue{static_cast<std::int64_t>(number)}
                       : ScriptValue{static_cast<double>(number)};
        }
        case json::value_t::number_float:
            return {value.get<double>()};
        case json::value_t::string:
            return {value.get<std::string>()};
        case json::value_t::array: {
            ScriptValue::List list;
            for (const json& item : value) {
                list.push_back(value_from(item, depth + 1));
            }
            return {std::move(list)};
        }
        case json::value_t::object:
            return {table_from(value, depth + 1)};
        default:
            return {};
    }
}

// nlohmann sorts names by their bytes, as a table wants them.
ScriptTable table_from(const json& object, int depth) {
    ScriptTable table;
    for (const auto& [name, value] : object.items()) {
        table.push_back({name, value_from(value, depth)});
    }
    return table;
}

}  // namespace

json json_from(const ScriptValue& value) {
    const auto convert = [](const auto& held) -> json {
        using Held = std::remove_cvref_t<decltype(held)>;
        if constexpr (std::is_same_v<Held, std::monostate>) {
            return nullptr;
        } else if constexpr (std::is_same_v<Held, ScriptValue::List>) {
            json list = json::array();
            for (const ScriptValue& item : held) {
                list.push_back(json_from(item));
            }
            return list;
        } else if constexpr (std::is_same_v<Held, ScriptTable>) {
            return json_from(held);
        } else {
            return held;
        }
    };
    return std::visit(convert, value.data);
}

json json_from(const ScriptTable& table) {
    json object = json::object();
    for (const ScriptField& field : table) {
        object[field.name] = json_from(field.value);
    }
    return object;
}

ScriptValue script_value_from(const json& value) {
    return value_from(value, 0);
}

ScriptTable script_table_from(const json& object) {
    return table_from(object, 0);
}

}  // namespace hyrax
