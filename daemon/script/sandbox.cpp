// SPDX-License-Identifier: MIT
// The allow-list. What is not named here does not exist for scripts.
#include "daemon/script/sandbox.h"

#include "daemon/script/script.h"
#include "daemon/script/weak_tables.h"

#include <lauxlib.h>
#include <lualib.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>

namespace hyrax::script {
namespace {

using Names = std::span<const std::string_view>;

constexpr std::string_view allowed_globals[]{
    "_G",     "_VERSION",     "assert", "collectgarbage", "coroutine", "error",
    "ipairs", "getmetatable", "load",   "math",           "next",      "pairs",
    "pcall",  "rawequal",     "rawget", "rawlen",         "rawset",    "require",
    "select", "setmetatable", "string", "table",          "tonumber",  "tostring",
    "type",   "utf8",         "xpcall",
};
constexpr std::string_view allowed_os[]{"clock", "difftime", "time"};
constexpr std::string_view allowed_debug[]{"traceback"};

// Removes from the table on top of the stack what is not allowed.
void keep_only(lua_State* lua, Names allowed) {
    lua_pushnil(lua);
    while (lua_next(lua, -2) != 0) {
        lua_pop(lua, 1);
        const char* const name = lua_tostring(lua, -1);
        if (std::ranges::find(allowed, std::string_view(name)) == allowed.end()) {
            lua_pushvalue(lua, -1);
            lua_pushnil(lua);
            lua_rawset(lua, -4);  // clearing a field that is being visited is allowed
        }
    }
}

// Opens a library without making it global; leaves its table on the stack. The table of loaded
// libraries is where messages find the names of functions.
void open(lua_State* lua, const char* name, lua_CFunction opener) {
    luaL_requiref(lua, name, opener, 0);
}

// Stock randomseed() without arguments would take the time and an address.
int randomseed(lua_State* lua) {
    if (lua_gettop(lua) == 0) {
        Script& script = Script::of(lua);
        lua_pushinteger(lua, static_cast<lua_Integer>(script.random_unit() * 0x1p53));
    }
    lua_pushvalue(lua, lua_upvalueindex(1));
    lua_insert(lua, 1);
    lua_call(lua, lua_gettop(lua) - 1, 0);
    return 0;
}

void open_math(lua_State* lua) {
    open(lua, LUA_MATHLIBNAME, luaopen_math);
    lua_getfield(lua, -1, "randomseed");
    lua_pushcclosure(lua, randomseed, 1);
    lua_pushvalue(lua, -1);
    lua_setfield(lua, -3, "randomseed");
    lua_call(lua, 0, 0);
    lua_setglobal(lua, LUA_MATHLIBNAME);
}

// Methods of strings come from the metatable; scripts may change the library, not the metatable.
void open_string(lua_State* lua) {
    open(lua, LUA_STRLIBNAME, luaopen_string);
    lua_pushnil(lua);
    lua_setfield(lua, -2, "dump");
    replace_text_functions(lua);
    lua_pushliteral(lua, "");
    lua_getmetatable(lua, -1);
    lua_pushliteral(lua, "string");
    lua_setfield(lua, -2, "__metatable");
    lua_pop(lua, 2);
    lua_setglobal(lua, LUA_STRLIBNAME);
}

}  // namespace

void open_sandbox(lua_State* lua, Script& script) {
    make_tables_strong(lua);
    // Half again before the next collection instead of double: a script may use most of its heap.
    lua_gc(lua, LUA_GCINC, 150, 0, 0);

    open(lua, LUA_GNAME, luaopen_base);
    replace_calls(lua);
    replace_conversions(lua);
    open(lua, LUA_COLIBNAME, luaopen_coroutine);
    replace_coroutines(lua);
    lua_setglobal(lua, LUA_COLIBNAME);
    open(lua, LUA_TABLIBNAME, luaopen_table);
    replace_table_functions(lua);
    lua_setglobal(lua, LUA_TABLIBNAME);
    open(lua, LUA_UTF8LIBNAME, luaopen_utf8);
    charge_for_texts(lua);
    lua_setglobal(lua, LUA_UTF8LIBNAME);
    open_string(lua);
    open_math(lua);
    keep_only(lua, allowed_globals);

    open(lua, LUA_OSLIBNAME, luaopen_os);
    keep_only(lua, allowed_os);
    lua_setglobal(lua, LUA_OSLIBNAME);
    open(lua, LUA_DBLIBNAME, luaopen_debug);
    keep_only(lua, allowed_debug);
    lua_setglobal(lua, LUA_DBLIBNAME);
    lua_pop(lua, 1);

    Meter::watch(lua);
    script.meter.check(lua);
}

}  // namespace hyrax::script
