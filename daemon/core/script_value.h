// SPDX-License-Identifier: MIT
// Values that scripts keep and settings that they read, as plain data: what JSON can hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace hyrax {

struct ScriptField;

/// Nothing, a truth value, a number, a text, a list or a table with names. Numbers are finite.
struct ScriptValue {
    using List = std::vector<ScriptValue>;
    using Table = std::vector<ScriptField>;  ///< Sorted by name, each name once.

    std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Table> data{};

    bool operator==(const ScriptValue& other) const;
    bool is_nothing() const { return std::holds_alternative<std::monostate>(data); }
};

struct ScriptField {
    std::string name;
    ScriptValue value;
    bool operator==(const ScriptField&) const = default;
};

inline bool ScriptValue::operator==(const ScriptValue& other) const {
    return data == other.data;
}

using ScriptTable = ScriptValue::Table;

/// Null where there is no such name.
const ScriptValue* find_field(const ScriptTable& table, const std::string& name);
/// Sets the field, or removes it where the value is nothing; keeps the order.
void set_field(ScriptTable& table, const std::string& name, ScriptValue value);
/// What it takes about to keep the value [bytes]: its texts and names, and 8 for each value.
std::size_t size_of(const ScriptValue& value);
std::size_t size_of(const ScriptTable& table);

}  // namespace hyrax
