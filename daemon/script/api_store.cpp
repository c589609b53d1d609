// SPDX-License-Identifier: MIT
// What belongs to a script: its store, its settings, its name.
#include "daemon/script/api.h"
#include "daemon/script/arguments.h"
#include "daemon/script/values.h"

#include <sol/sol.hpp>

#include <string>
#include <utility>

namespace hyrax::script {
namespace {

constexpr char config_key = 0;
constexpr std::size_t longest_key = 64;

std::string key_argument(lua_State* lua, const char* what) {
    std::string key = text_argument(lua, 1, what, longest_key);
    if (key.empty()) {
        luaL_error(lua, "%s must not be empty", what);
    }
    return key;
}

int store_get(lua_State* lua, Script& script) {
    const std::string key = key_argument(lua, "hyrax.store.get: key");
    if (const ScriptValue* const value = find_field(script.belongings.store, key)) {
        push_value(lua, *value);
    } else {
        lua_settop(lua, 2);  // the default, nil if there is none
    }
    return 1;
}

int store_set(lua_State* lua, Script& script) {
    Belongings& own = script.belongings;
    const std::string key = key_argument(lua, "hyrax.store.set: key");
    luaL_checkany(lua, 2);
    ScriptValue value = value_argument(lua, 2, "hyrax.store.set: value", script.limits.store);
    const ScriptValue* const old = find_field(own.store, key);
    if (old == nullptr ? value.is_nothing() : *old == value) {
        return 0;
    }
    const std::size_t before = old == nullptr ? 0 : key.size() + size_of(*old);
    const std::size_t after = value.is_nothing() ? 0 : key.size() + size_of(value);
    if (own.store_size - before + after > script.limits.store) {
        return luaL_error(
            lua,
            "hyrax.store.set: limit of %d bytes in the store reached",
            static_cast<int>(script.limits.store)
        );
    }
    script.command(lua, command::Store{script.name(), key, value});
    own.store_size = own.store_size - before + after;
    set_field(own.store, key, std::move(value));
    return 0;
}

int config_newindex(lua_State* lua, Script& /*script*/) {
    return luaL_error(lua, "hyrax.config can only be read; the user changes it");
}

// The upvalue holds the settings. A function of its own, so that next() does not give them away.
int config_next(lua_State* lua, Script& /*script*/) {
    lua_settop(lua, 2);
    return lua_next(lua, lua_upvalueindex(1)) == 0 ? 0 : 2;
}

int config_pairs(lua_State* lua, Script& /*script*/) {
    lua_rawgetp(lua, LUA_REGISTRYINDEX, &config_key);
    lua_pushcclosure(lua, api<config_next>, 1);
    lua_pushvalue(lua, 1);
    lua_pushnil(lua);
    return 3;
}

// An empty table in front of the settings, which the script cannot reach to change.
void push_config(lua_State* lua, const ScriptTable& settings) {
    lua_newtable(lua);
    lua_createtable(lua, 0, 4);
    push_value(lua, {settings});
    lua_pushvalue(lua, -1);
    lua_rawsetp(lua, LUA_REGISTRYINDEX, &config_key);
    lua_setfield(lua, -2, "__index");
    constexpr luaL_Reg metamethods[] = {
        {"__newindex", api<config_newindex>}, {"__pairs", api<config_pairs>}, {nullptr, nullptr}
    };
    luaL_setfuncs(lua, metamethods, 0);
    lua_pushboolean(lua, 0);
    lua_setfield(lua, -2, "__metatable");
    lua_setmetatable(lua, -2);
}

}  // namespace

void set_config(lua_State* lua, const std::string& key) {
    lua_rawgetp(lua, LUA_REGISTRYINDEX, &config_key);
    lua_insert(lua, -2);
    lua_pushlstring(lua, key.data(), key.size());
    lua_insert(lua, -2);
    lua_rawset(lua, -3);
    lua_pop(lua, 1);
}

void open_store_api(lua_State* lua) {
    const Script& script = Script::of(lua);
    constexpr luaL_Reg functions[] = {
        {"get", api<store_get>}, {"set", api<store_set>}, {nullptr, nullptr}
    };
    luaL_newlib(lua, functions);
    lua_setfield(lua, -2, "store");
    push_config(lua, script.belongings.config);
    lua_setfield(lua, -2, "config");

    sol::stack_table hyrax(lua, -1);
    hyrax["plugin"] = sol::state_view(lua).create_table_with(
        "id", script.name(), "version", script.belongings.version
    );
}

}  // namespace hyrax::script
