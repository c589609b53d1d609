// SPDX-License-Identifier: MIT
// Between Lua's values and the plain ones that the daemon keeps.
#pragma once

#include "daemon/core/script_value.h"

#include <lua.h>

#include <string>

namespace hyrax::script {

/// Pushes a copy.
void push_value(lua_State* lua, const ScriptValue& value);
/// A copy of nil, a boolean, a finite number, a text in UTF-8, or a plain table of such: a list
/// from 1 on, or names. Read raw. Anything else, and more than `most` bytes, is an error that names
/// the place. `what` is "hyrax.store.set: value".
ScriptValue value_argument(lua_State* lua, int index, const std::string& what, std::size_t most);

}  // namespace hyrax::script
