// SPDX-License-Identifier: MIT
// Stores as JSON.
#include "daemon/core/script_stores.h"
#include "daemon/core/script_value_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hyrax {
using nlohmann::json;

std::string json_of(const ScriptTable& table) {
    // Texts were checked where they came in; what is no UTF-8 all the same must not throw.
    return json_from(table).dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

Result<ScriptTable> parse_store(std::string_view text, std::string_view file) {
    const json root = json::parse(text, nullptr, false);
    if (root.is_discarded()) {
        return failure(fmt::format("{}: is no JSON", file));
    }
    if (!root.is_object()) {
        return failure(fmt::format("{}: expected an object, got {}", file, root.type_name()));
    }
    return script_table_from(root);
}

}  // namespace hyrax
