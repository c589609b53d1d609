// SPDX-License-Identifier: MIT
// What scripts write into the log.
#include "daemon/script/api.h"
#include "daemon/script/sandbox.h"

#include <string_view>

namespace hyrax::script {
namespace {

std::string_view text_at(lua_State* lua, int index) {
    std::size_t length = 0;
    const char* const text = lua_tolstring(lua, index, &length);
    return {text, length};
}

// With one argument the text is taken as it is, so that a "%" in it does no harm.
template <LogLevel level>
int log(lua_State* lua, Script& script) {
    luaL_checkany(lua, 1);
    if (lua_gettop(lua) == 1) {
        push_text(lua, 1);
    } else {
        luaL_checktype(lua, 1, LUA_TSTRING);
        push_formatted(lua, 1);
    }
    script.journal.say(level, text_at(lua, -1));
    return 0;
}

int print(lua_State* lua, Script& script) {
    const int values = lua_gettop(lua);
    luaL_Buffer line;
    luaL_buffinit(lua, &line);
    for (int i = 1; i <= values; ++i) {
        if (i > 1) {
            luaL_addchar(&line, ' ');
        }
        push_text(lua, i);
        luaL_addvalue(&line);
    }
    luaL_pushresult(&line);
    script.journal.say(LogLevel::info, text_at(lua, -1));
    return 0;
}

}  // namespace

void open_log_api(lua_State* lua) {
    constexpr luaL_Reg functions[] = {
        {"error", api<log<LogLevel::error>>},
        {"info", api<log<LogLevel::info>>},
        {"warn", api<log<LogLevel::warning>>},
        {nullptr, nullptr},
    };
    luaL_newlib(lua, functions);
    lua_setfield(lua, -2, "log");
    lua_pushcfunction(lua, api<print>);
    lua_setglobal(lua, "print");
}

void open_api(lua_State* lua) {
    lua_newtable(lua);
    open_pet_api(lua);
    open_pets_api(lua);
    open_events_api(lua);
    open_time_api(lua);
    open_world_api(lua);
    open_log_api(lua);
    open_store_api(lua);
    open_permitted_api(lua);
    if (Script::of(lua).tests.enabled()) {
        open_test_api(lua);
    }
    // Here messages find the names of functions, and require finds the module.
    luaL_getsubtable(lua, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
    lua_pushvalue(lua, -2);
    lua_setfield(lua, -2, "hyrax");
    lua_pop(lua, 1);
    lua_setglobal(lua, "hyrax");
}

}  // namespace hyrax::script
