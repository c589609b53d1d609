// SPDX-License-Identifier: MIT
// Stock Lua collects tables with weak keys in quadratic time, in one step that nothing interrupts.
#pragma once

struct lua_State;

namespace hyrax::script {

/// From here on `__mode` means nothing in this state: tables hold what is in them. To be called
/// before any script code runs; may raise a Lua error.
void make_tables_strong(lua_State* lua);

}  // namespace hyrax::script
