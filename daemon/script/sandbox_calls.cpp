// SPDX-License-Identifier: MIT
// Calls that catch errors, and what they must not catch: the end of a script.
#include "daemon/script/sandbox.h"
#include "daemon/script/script.h"

#include <lauxlib.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace hyrax::script {
namespace {

// Compiling costs about this much more than running the same text once.
constexpr std::int64_t units_per_byte = 10;

// Results of a protected call: `skip` values below them stay on the stack.
int finish_call(lua_State* lua, int status, lua_KContext skip) {
    Script::of(lua).meter.check(lua);
    if (status != LUA_OK && status != LUA_YIELD) {
        lua_pushboolean(lua, 0);
        lua_pushvalue(lua, -2);
        return 2;
    }
    return lua_gettop(lua) - static_cast<int>(skip);
}

int protected_call(lua_State* lua) {
    Script::of(lua).meter.check(lua);
    luaL_checkany(lua, 1);
    lua_pushboolean(lua, 1);
    lua_insert(lua, 1);
    const int status = lua_pcallk(lua, lua_gettop(lua) - 2, LUA_MULTRET, 0, 0, finish_call);
    return finish_call(lua, status, 0);
}

// Lua calls the message handler of xpcall where the error is raised: for a spent budget that is
// inside the hook, where no other hook stops it.
int guarded_handler(lua_State* lua) {
    Script& script = Script::of(lua);
    if (script.meter.killed()) {
        return 1;
    }
    lua_pushvalue(lua, lua_upvalueindex(1));
    lua_insert(lua, 1);
    lua_call(lua, lua_gettop(lua) - 1, 1);
    return 1;
}

int protected_call_with_handler(lua_State* lua) {
    Script::of(lua).meter.check(lua);
    const int arguments = lua_gettop(lua) - 2;
    luaL_checktype(lua, 2, LUA_TFUNCTION);
    lua_pushvalue(lua, 2);
    lua_pushcclosure(lua, guarded_handler, 1);
    lua_replace(lua, 2);
    lua_pushboolean(lua, 1);
    lua_pushvalue(lua, 1);
    lua_rotate(lua, 3, 2);
    const int status = lua_pcallk(lua, arguments, LUA_MULTRET, 2, 2, finish_call);
    return finish_call(lua, status, 2);
}

// Finalizers run where no hook stops them.
int set_metatable(lua_State* lua) {
    const int type = lua_type(lua, 2);
    luaL_checktype(lua, 1, LUA_TTABLE);
    luaL_argexpected(lua, type == LUA_TNIL || type == LUA_TTABLE, 2, "nil or table");
    if (luaL_getmetafield(lua, 1, "__metatable") != LUA_TNIL) {
        return luaL_error(lua, "cannot change a protected metatable");
    }
    if (type == LUA_TTABLE) {
        lua_pushliteral(lua, "__gc");
        if (lua_rawget(lua, 2) != LUA_TNIL) {
            return luaL_error(lua, "__gc is not available to scripts; use __close");
        }
        lua_pushliteral(lua, "__mode");
        if (lua_rawget(lua, 2) == LUA_TSTRING &&
            std::string_view(lua_tostring(lua, -1)).contains('k')) {
            return luaL_error(
                lua,
                "__mode = \"k\" is not available to scripts; tables hold "
                "what is in them"
            );
        }
    }
    lua_settop(lua, 2);
    lua_setmetatable(lua, 1);
    return 1;
}

int too_long(lua_State* lua, std::size_t limit) {
    luaL_pushfail(lua);
    lua_pushfstring(lua, "text for load is over the limit of %d bytes", static_cast<int>(limit));
    return 2;
}

// Collects what the reader function returns, until nil or an empty string.
bool read_pieces(lua_State* lua, std::string& text, std::size_t limit) {
    Script& script = Script::of(lua);
    while (text.size() <= limit) {
        script.meter.charge(lua, units_per_byte);
        lua_pushvalue(lua, 1);
        lua_call(lua, 0, 1);
        if (lua_isnil(lua, -1)) {
            lua_pop(lua, 1);
            return true;
        }
        if (lua_type(lua, -1) != LUA_TSTRING) {
            luaL_error(lua, "reader function must return a string");
        }
        const std::string_view piece(lua_tostring(lua, -1), lua_rawlen(lua, -1));
        const bool last = piece.empty();
        text.append(piece.substr(0, limit + 1));
        lua_pop(lua, 1);
        if (last) {
            return true;
        }
    }
    return false;
}

// Text only, whatever mode is asked for: crafted bytecode takes over the VM.
int load(lua_State* lua) {
    Script& script = Script::of(lua);
    const std::size_t limit = script.limits.chunk;
    const char* name = luaL_optstring(lua, 2, nullptr);
    const bool has_environment = !lua_isnone(lua, 4);
    std::string text;
    if (lua_type(lua, 1) == LUA_TSTRING) {
        if (lua_rawlen(lua, 1) > limit) {
            return too_long(lua, limit);
        }
        text.assign(lua_tostring(lua, 1), lua_rawlen(lua, 1));
        name = name == nullptr ? lua_tostring(lua, 1) : name;
    } else {
        luaL_checktype(lua, 1, LUA_TFUNCTION);
        if (!read_pieces(lua, text, limit)) {
            return too_long(lua, limit);
        }
        name = name == nullptr ? "=(load)" : name;
    }
    script.meter.charge(lua, static_cast<std::int64_t>(text.size()) * units_per_byte);
    const int status = luaL_loadbufferx(lua, text.data(), text.size(), name, "t");
    script.meter.check(lua);
    if (status != LUA_OK) {
        luaL_pushfail(lua);
        lua_insert(lua, -2);
        return 2;
    }
    if (has_environment) {
        lua_pushvalue(lua, 4);
        if (lua_setupvalue(lua, -2, 1) == nullptr) {
            lua_pop(lua, 1);
        }
    }
    return 1;
}

// Of a state: what each module returned.
constexpr char loaded_modules[] = "hyrax.modules";

// Runs the text once. While it runs, and if it fails, the module stands for false.
int require_module(lua_State* lua, std::string_view name) {
    Script& script = Script::of(lua);
    const auto& modules = script.belongings.modules;
    const auto module = std::ranges::find(modules, name, &ScriptModule::name);
    if (module == modules.end()) {
        return luaL_error(
            lua,
            modules.empty() ? "require: there is no module '%s'; scripts can require 'hyrax' only"
                            : "require: there is no module '%s' in this plugin",
            lua_tostring(lua, 1)
        );
    }
    luaL_getsubtable(lua, LUA_REGISTRYINDEX, loaded_modules);
    const int loaded = lua_gettop(lua);
    if (lua_getfield(lua, loaded, module->name.c_str()) == LUA_TBOOLEAN &&
        lua_toboolean(lua, -1) == 0) {
        return luaL_error(
            lua, "require: module '%s' is just being loaded, or has failed", module->name.c_str()
        );
    }
    if (!lua_isnil(lua, -1)) {
        return 1;
    }
    lua_pushboolean(lua, 0);
    lua_setfield(lua, loaded, module->name.c_str());
    script.meter.charge(lua, static_cast<std::int64_t>(module->text.size()) * units_per_byte);
    std::string chunk = "@" + script.name() + "/" + module->name;
    std::ranges::replace(chunk, '.', '/');
    chunk += ".lua";
    if (luaL_loadbufferx(lua, module->text.data(), module->text.size(), chunk.c_str(), "t") !=
        LUA_OK) {
        return lua_error(lua);
    }
    lua_pushvalue(lua, 1);
    lua_call(lua, 1, 1);
    if (lua_isnil(lua, -1) || (lua_isboolean(lua, -1) && lua_toboolean(lua, -1) == 0)) {
        lua_pushboolean(lua, 1);
    }
    lua_pushvalue(lua, -1);
    lua_setfield(lua, loaded, module->name.c_str());
    return 1;
}

// No path is ever built from a script's text.
int require(lua_State* lua) {
    constexpr std::size_t longest_name = 64;
    luaL_checktype(lua, 1, LUA_TSTRING);
    const std::string_view name(lua_tostring(lua, 1), lua_rawlen(lua, 1));
    if (name == "hyrax") {
        luaL_getsubtable(lua, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
        lua_getfield(lua, -1, "hyrax");
        return 1;
    }
    if (name.size() > longest_name) {
        return luaL_error(
            lua, "require: the name is longer than %d bytes", static_cast<int>(longest_name)
        );
    }
    return require_module(lua, name);
}

int collect_garbage(lua_State* lua) {
    if (lua_type(lua, 1) != LUA_TSTRING || std::string_view(lua_tostring(lua, 1)) != "count") {
        return luaL_error(lua, "collectgarbage: only \"count\" is available to scripts");
    }
    lua_pushnumber(lua, static_cast<lua_Number>(Script::of(lua).meter.heap()) / 1024.0);
    return 1;
}

}  // namespace

void replace_calls(lua_State* globals) {
    constexpr luaL_Reg functions[] = {
        {"collectgarbage", collect_garbage},
        {"load", load},
        {"pcall", protected_call},
        {"require", require},
        {"setmetatable", set_metatable},
        {"xpcall", protected_call_with_handler},
        {nullptr, nullptr},
    };
    luaL_setfuncs(globals, functions, 0);
}

}  // namespace hyrax::script
