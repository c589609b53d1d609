// SPDX-License-Identifier: MIT
// Values of scripts from JSON and as JSON. Only for the *_json.cpp files.
#pragma once

#include "daemon/core/script_value.h"

#include <nlohmann/json.hpp>

namespace hyrax {

nlohmann::json json_from(const ScriptTable& table);
nlohmann::json json_from(const ScriptValue& value);

/// Whole numbers stay whole. Null is nothing, and so is what is deeper than a value may be.
ScriptValue script_value_from(const nlohmann::json& value);
/// Of an object.
ScriptTable script_table_from(const nlohmann::json& object);

}  // namespace hyrax
