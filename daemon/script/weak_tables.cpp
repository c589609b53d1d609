// SPDX-License-Identifier: MIT
// The only file that knows Lua's insides; a test checks that they are as expected.
#include "daemon/script/weak_tables.h"

#include <lauxlib.h>
#include <lobject.h>
#include <lstate.h>
#include <ltm.h>
#include <lua.h>

namespace hyrax::script {

// 30 000 chained tables with weak keys take the collector seconds (convergeephemerons in lgc.c),
// and `rawset(mt, "__mode", "k")` after setmetatable cannot be refused. The collector looks for the
// metafield by the identity of a short string; a long string is never identical to a script's.
void make_tables_strong(lua_State* lua) {
    static_assert(LUAI_MAXSHORTLEN < 60);
    lua_pushliteral(lua, "the collector looks for this name instead of the one for weak tables");
    G(lua)->tmname[TM_MODE] = tsvalue(s2v(lua->top.p - 1));
    luaL_ref(lua, LUA_REGISTRYINDEX);
}

}  // namespace hyrax::script
