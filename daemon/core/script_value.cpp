// SPDX-License-Identifier: MIT
#include "daemon/core/script_value.h"

#include <algorithm>
#include <utility>

namespace hyrax {
namespace {

constexpr std::size_t bytes_of_a_value = 8;

}  // namespace

const ScriptValue* find_field(const ScriptTable& table, const std::string& name) {
    const auto found = std::ranges::lower_bound(table, name, {}, &ScriptField::name);
    return found != table.end() && found->name == name ? &found->value : nullptr;
}

void set_field(ScriptTable& table, const std::string& name, ScriptValue value) {
    const auto found = std::ranges::lower_bound(table, name, {}, &ScriptField::name);
    const bool there = found != table.end() && found->name == name;
    if (value.is_nothing()) {
        if (there) {
            table.erase(found);
        }
    } else if (there) {
        found->value = std::move(value);
    } else {
        table.insert(found, {name, std::move(value)});
    }
}

std::size_t size_of(const ScriptValue& value) {
    std::size_t bytes = bytes_of_a_value;
    if (const auto* const text = std::get_if<std::string>(&value.data)) {
        bytes += text->size();
    } else if (const auto* const list = std::get_if<ScriptValue::List>(&value.data)) {
        for (const ScriptValue& item : *list) {
            bytes += size_of(item);
        }
    } else if (const auto* const table = std::get_if<ScriptTable>(&value.data)) {
        bytes += size_of(*table);
    }
    return bytes;
}

std::size_t size_of(const ScriptTable& table) {
    std::size_t bytes = 0;
    for (const ScriptField& field : table) {
        bytes += field.name.size() + size_of(field.value);
    }
    return bytes;
}

}  // namespace hyrax
