// SPDX-License-Identifier: MIT
// Where a script was: the calls of a coroutine, taken without allocating in Lua's heap.
#pragma once

#include <string>
#include <vector>

struct lua_State;

namespace hyrax::script {

struct CallTrace {
    std::string where;                ///< "fountain.lua:12", empty where no script code runs.
    std::vector<std::string> frames;  ///< "fountain.lua:12: in function 'jet'", innermost first.
};

/// The innermost and outermost calls, from `level` (0: the running function) outwards.
CallTrace call_trace(lua_State* lua, int level);

}  // namespace hyrax::script
