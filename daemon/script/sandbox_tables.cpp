// SPDX-License-Identifier: MIT
// Table functions that loop in C: they charge for the elements before they touch them.
#include "daemon/script/sandbox.h"
#include "daemon/script/script.h"

#include <lauxlib.h>

#include <algorithm>
#include <bit>
#include <cstdint>

namespace hyrax::script {
namespace {

// Above every budget, and far from overflow in sums.
constexpr lua_Unsigned plenty = lua_Unsigned{1} << 40U;
constexpr lua_Unsigned bytes_per_unit = 32;

void charge(lua_State* lua, lua_Unsigned elements) {
    Script::of(lua).meter.charge(lua, static_cast<std::int64_t>(std::min(elements, plenty)));
}

// Elements from `first` to `last`, 0 if there are none.
lua_Unsigned span_of(lua_Integer first, lua_Integer last) {
    return first > last ? 0
                        : static_cast<lua_Unsigned>(last) - static_cast<lua_Unsigned>(first) + 1U;
}

int insert(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    const lua_Integer end =
        static_cast<lua_Integer>(static_cast<lua_Unsigned>(luaL_len(lua, 1)) + 1U);
    lua_Integer position = end;
    switch (lua_gettop(lua)) {
        case 2:
            break;
        case 3:
            position = luaL_checkinteger(lua, 2);
            luaL_argcheck(
                lua,
                static_cast<lua_Unsigned>(position) - 1U < static_cast<lua_Unsigned>(end),
                2,
                "position out of bounds"
            );
            charge(lua, span_of(position, end));
            for (lua_Integer i = end; i > position; --i) {
                lua_geti(lua, 1, i - 1);
                lua_seti(lua, 1, i);
            }
            break;
        default:
            return luaL_error(lua, "wrong number of arguments to 'insert'");
    }
    lua_seti(lua, 1, position);
    return 0;
}

int remove(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    const lua_Integer size = luaL_len(lua, 1);
    lua_Integer position = luaL_optinteger(lua, 2, size);
    if (position != size) {
        luaL_argcheck(
            lua,
            static_cast<lua_Unsigned>(position) - 1U <= static_cast<lua_Unsigned>(size),
            2,
            "position out of bounds"
        );
    }
    charge(lua, span_of(position, size));
    lua_geti(lua, 1, position);
    for (; position < size; ++position) {
        lua_geti(lua, 1, position + 1);
        lua_seti(lua, 1, position);
    }
    lua_pushnil(lua);
    lua_seti(lua, 1, position);
    return 1;
}

// The library's function, the first upvalue, runs in this frame, so that messages find its name.
int move(lua_State* lua) {
    charge(lua, span_of(luaL_checkinteger(lua, 2), luaL_checkinteger(lua, 3)));
    return lua_tocfunction(lua, lua_upvalueindex(1))(lua);
}

// Comparisons of a sort, and what comparing long strings adds.
lua_Unsigned sort_units(lua_State* lua, int index, lua_Unsigned size) {
    lua_Unsigned units = size;
    for (lua_Unsigned i = 1; i <= size; ++i) {
        if (lua_rawgeti(lua, index, static_cast<lua_Integer>(i)) == LUA_TSTRING) {
            units += lua_rawlen(lua, -1) / bytes_per_unit;
        }
        lua_pop(lua, 1);
    }
    return units * std::bit_width(size);
}

int sort_plain(lua_State* lua) {
    charge(lua, sort_units(lua, 1, lua_rawlen(lua, 1)));
    return lua_tocfunction(lua, lua_upvalueindex(1))(lua);
}

// A length that the script computes may be another one each time it is asked for: it is asked for
// once, and a copy of that length is sorted.
int sort(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    if (luaL_getmetafield(lua, 1, "__len") == LUA_TNIL) {
        return sort_plain(lua);
    }
    lua_pop(lua, 1);
    const lua_Integer size = std::max<lua_Integer>(luaL_len(lua, 1), 0);
    charge(lua, static_cast<lua_Unsigned>(size));
    lua_settop(lua, 2);
    lua_newtable(lua);
    for (lua_Integer i = 1; i <= size; ++i) {
        lua_geti(lua, 1, i);
        lua_rawseti(lua, 3, i);
    }
    charge(lua, sort_units(lua, 3, static_cast<lua_Unsigned>(size)));
    lua_pushcfunction(lua, lua_tocfunction(lua, lua_upvalueindex(1)));
    lua_pushvalue(lua, 3);
    lua_pushvalue(lua, 2);
    lua_call(lua, 2, 0);
    for (lua_Integer i = 1; i <= size; ++i) {
        lua_rawgeti(lua, 3, i);
        lua_seti(lua, 1, i);
    }
    return 0;
}

void wrap(lua_State* lua, const char* name, lua_CFunction wrapper) {
    lua_getfield(lua, -1, name);
    lua_pushcclosure(lua, wrapper, 1);
    lua_setfield(lua, -2, name);
}

}  // namespace

void replace_table_functions(lua_State* table) {
    constexpr luaL_Reg functions[] = {{"insert", insert}, {"remove", remove}, {nullptr, nullptr}};
    luaL_setfuncs(table, functions, 0);
    wrap(table, "move", move);
    wrap(table, "sort", sort);
}

}  // namespace hyrax::script
