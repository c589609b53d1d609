// SPDX-License-Identifier: MIT
#include "daemon/script/values.h"

#include "daemon/script/arguments.h"
#include "daemon/script/script.h"
#include "daemon/script/text.h"

#include <fmt/format.h>
#include <lauxlib.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace hyrax::script {
namespace {

constexpr int deepest = 16;  // Tables in tables; one that holds itself is deeper.
constexpr std::size_t longest_name = 64;
constexpr std::int64_t units_per_value = 10;

// Reads one value and those in it, and knows where it is.
class Reader {
public:
    Reader(lua_State* lua, std::size_t most) : lua_(lua), left_(most), most_(most) {}

    // The value on top of the stack, which stays there.
    ScriptValue read(const std::string& what, int depth) {
        Script::of(lua_).meter.charge(lua_, units_per_value);
        spend(what, 8);
        switch (lua_type(lua_, -1)) {
            case LUA_TNIL:
                return {};
            case LUA_TBOOLEAN:
                return {lua_toboolean(lua_, -1) != 0};
            case LUA_TNUMBER:
                return number(what);
            case LUA_TSTRING:
                return {text(what)};
            case LUA_TTABLE:
                return table(what, depth);
            default:
                raise_error(
                    lua_,
                    fmt::format(
                        "{} must be nil, a boolean, a number, a string or a table of them, got a "
                        "{}",
                        what,
                        luaL_typename(lua_, -1)
                    )
                );
        }
    }

private:
    void spend(const std::string& what, std::size_t bytes) {
        if (bytes > left_) {
            raise_error(lua_, fmt::format("{} is over the limit of {} bytes", what, most_));
        }
        left_ -= bytes;
    }

    ScriptValue number(const std::string& what) {
        if (lua_isinteger(lua_, -1) != 0) {
            return {std::int64_t{lua_tointeger(lua_, -1)}};
        }
        return {number_argument(lua_, -1, what.c_str())};
    }

    std::string text(const std::string& what) {
        const std::string_view text(lua_tostring(lua_, -1), lua_rawlen(lua_, -1));
        spend(what, text.size());
        if (!is_utf8(text)) {
            raise_error(lua_, fmt::format("{} must be UTF-8", what));
        }
        return std::string(text);
    }

    ScriptValue table(const std::string& what, int depth) {
        if (depth == deepest) {
            raise_error(lua_, fmt::format("{} holds tables more than {} deep", what, deepest));
        }
        luaL_checkstack(lua_, 4, "too many tables in tables");
        const auto length = static_cast<lua_Integer>(lua_rawlen(lua_, -1));
        return length > 0 ? list(what, depth, length) : names(what, depth);
    }

    ScriptValue list(const std::string& what, int depth, lua_Integer length) {
        lua_Integer keys = 0;
        lua_pushnil(lua_);
        for (; lua_next(lua_, -2) != 0; ++keys) {
            lua_pop(lua_, 1);
            if (lua_isinteger(lua_, -1) == 0) {
                raise_error(lua_, fmt::format("{} mixes a list with other keys", what));
            }
        }
        if (keys != length) {
            raise_error(lua_, fmt::format("{} is a list with holes", what));
        }
        ScriptValue::List items;
        for (lua_Integer i = 1; i <= length; ++i) {
            lua_rawgeti(lua_, -1, i);
            items.push_back(read(fmt::format("{}[{}]", what, i), depth + 1));
            lua_pop(lua_, 1);
        }
        return {std::move(items)};
    }

    ScriptValue names(const std::string& what, int depth) {
        ScriptTable fields;
        lua_pushnil(lua_);
        while (lua_next(lua_, -2) != 0) {
            if (lua_type(lua_, -2) != LUA_TSTRING) {
                raise_error(
                    lua_,
                    fmt::format(
                        "{} must have names or a list from 1 on as keys, got a {}",
                        what,
                        luaL_typename(lua_, -2)
                    )
                );
            }
            const std::string name(lua_tostring(lua_, -2), lua_rawlen(lua_, -2));
            if (name.size() > longest_name || !is_plain_text(name)) {
                raise_error(
                    lua_,
                    fmt::format("{}: names must have at most {} bytes of UTF-8", what, longest_name)
                );
            }
            spend(what, name.size());
            fields.push_back({name, read(fmt::format("{}.{}", what, name), depth + 1)});
            lua_pop(lua_, 1);
        }
        std::ranges::sort(fields, {}, &ScriptField::name);
        return {std::move(fields)};
    }

    lua_State* lua_;
    std::size_t left_;
    std::size_t most_;
};

}  // namespace

void push_value(lua_State* lua, const ScriptValue& value) {
    Script::of(lua).meter.charge(lua, units_per_value);
    luaL_checkstack(lua, 4, "too many tables in tables");
    const auto push = [lua](const auto& held) {
        using Held = std::remove_cvref_t<decltype(held)>;
        if constexpr (std::is_same_v<Held, std::monostate>) {
            lua_pushnil(lua);
        } else if constexpr (std::is_same_v<Held, bool>) {
            lua_pushboolean(lua, held ? 1 : 0);
        } else if constexpr (std::is_same_v<Held, std::int64_t>) {
            lua_pushinteger(lua, held);
        } else if constexpr (std::is_same_v<Held, double>) {
            lua_pushnumber(lua, held);
        } else if constexpr (std::is_same_v<Held, std::string>) {
            lua_pushlstring(lua, held.data(), held.size());
        } else if constexpr (std::is_same_v<Held, ScriptValue::List>) {
            lua_createtable(lua, static_cast<int>(held.size()), 0);
            for (std::size_t i = 0; i < held.size(); ++i) {
                push_value(lua, held[i]);
                lua_rawseti(lua, -2, static_cast<lua_Integer>(i + 1));
            }
        } else {
            static_assert(std::is_same_v<Held, ScriptTable>);
            lua_createtable(lua, 0, static_cast<int>(held.size()));
            for (const ScriptField& field : held) {
                lua_pushlstring(lua, field.name.data(), field.name.size());
                push_value(lua, field.value);
                lua_rawset(lua, -3);
            }
        }
    };
    std::visit(push, value.data);
}

ScriptValue value_argument(lua_State* lua, int index, const std::string& what, std::size_t most) {
    lua_pushvalue(lua, index);
    ScriptValue value = Reader(lua, most).read(what, 0);
    lua_pop(lua, 1);
    return value;
}

}  // namespace hyrax::script
