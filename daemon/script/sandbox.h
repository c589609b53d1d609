// SPDX-License-Identifier: MIT
// What of Lua a script gets: the allow-list, and own versions of what stock Lua leaves open.
#pragma once

#include <lua.h>

namespace hyrax::script {

class Script;

/// Fills a fresh state. May raise a Lua error.
void open_sandbox(lua_State* lua, Script& script);

// --- the parts: each works on the table on top of the stack ---

/// pcall, xpcall, setmetatable, load, require, collectgarbage.
void replace_calls(lua_State* globals);
/// create, resume, wrap, close, yield, isyieldable.
void replace_coroutines(lua_State* coroutine);
/// Charges for the length of texts; format without addresses.
void replace_text_functions(lua_State* string);
void charge_for_texts(lua_State* library);
/// insert, remove, move and sort charge for the elements that they touch.
void replace_table_functions(lua_State* table);
/// tostring, tonumber.
void replace_conversions(lua_State* globals);

/// Pushes what tostring() answers: no address, only a name that differs for different objects.
void push_text(lua_State* lua, int index);
/// Pushes the text of string.format for the format at `first` and the arguments behind it.
void push_formatted(lua_State* lua, int first);

}  // namespace hyrax::script
