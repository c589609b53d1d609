// SPDX-License-Identifier: MIT
// Text functions: charged for lengths, which no instruction count sees, and without addresses.
#include "daemon/script/sandbox.h"
#include "daemon/script/script.h"

#include <lauxlib.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string_view>

namespace hyrax::script {
namespace {

// A linear pass over a text costs less than this; the clock ends what is undercounted.
constexpr std::size_t bytes_per_unit = 32;
// Searching a text for another, or for a set of characters, compares up to the product of both
// lengths; this is far above what honest searches cost and far below what the worst ones do.
constexpr std::size_t comparisons_per_unit = 1'024;
// Longer digits have no meaning, and the C library of Windows needs quadratic time for them.
constexpr std::size_t longest_number = 200;

std::size_t text_length(lua_State* lua, int index) {
    return lua_type(lua, index) == LUA_TSTRING ? lua_rawlen(lua, index) : 0;
}

// Runs a library function, the first upvalue, in this frame, so that messages find its name.
int run_original(lua_State* lua) {
    return lua_tocfunction(lua, lua_upvalueindex(1))(lua);
}

int charged(lua_State* lua) {
    std::size_t bytes = 0;
    for (int i = lua_gettop(lua); i > 0; --i) {
        bytes += text_length(lua, i);
    }
    Script::of(lua).meter.charge(lua, static_cast<std::int64_t>(bytes / bytes_per_unit) + 1);
    return run_original(lua);
}

int charged_search(lua_State* lua) {
    const std::size_t subject = text_length(lua, 1);
    const std::size_t pattern = text_length(lua, 2);
    const std::size_t units = subject * pattern / comparisons_per_unit;
    Script::of(lua).meter.charge(lua, static_cast<std::int64_t>(units) + 1);
    return run_original(lua);
}

void charge(lua_State* lua, const char* name, lua_CFunction charging) {
    if (lua_getfield(lua, -1, name) == LUA_TFUNCTION) {
        lua_pushcclosure(lua, charging, 1);
        lua_setfield(lua, -2, name);
    } else {
        lua_pop(lua, 1);
    }
}

// Differs between programs, so that an address cannot be computed from what it hides.
std::uint64_t salt() {
    static const std::uint64_t value = (std::uint64_t{std::random_device()()} << 32U) | 1U;
    return value;
}

std::uint32_t disguised(const void* address) {
    std::uint64_t z = reinterpret_cast<std::uintptr_t>(address) ^ salt();
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return static_cast<std::uint32_t>(z >> 32U);
}

struct Directive {
    char conversion = 0;
    std::size_t end = 0;  ///< Behind it.
};

// The next directive with an argument at or after `from`; conversion 0: none.
Directive next_directive(std::string_view format, std::size_t from) {
    std::size_t i = format.find('%', from);
    while (i != std::string_view::npos && i + 1 < format.size() && format[i + 1] == '%') {
        i = format.find('%', i + 2);
    }
    if (i == std::string_view::npos) {
        return {};
    }
    i = format.find_first_not_of("-+#0 .123456789", i + 1);
    return i == std::string_view::npos ? Directive{} : Directive{format[i], i + 1};
}

// Stock format shows addresses of tables for %s and of anything for %p.
void hide_addresses(lua_State* lua) {
    std::size_t length = 0;
    const char* const text = luaL_checklstring(lua, 1, &length);
    const std::string_view format(text, length);
    const int arguments = lua_gettop(lua);
    int index = 2;
    for (Directive d = next_directive(format, 0); d.conversion != 0 && index <= arguments;
         d = next_directive(format, d.end), ++index) {
        if (d.conversion == 'p') {
            luaL_error(lua, "invalid conversion '%%p' to 'format'");
        }
        const int type = lua_type(lua, index);
        if (d.conversion == 's' && type != LUA_TSTRING && type != LUA_TNUMBER) {
            push_text(lua, index);
            lua_replace(lua, index);
        }
    }
}

int format(lua_State* lua) {
    Script::of(lua).meter.check(lua);
    hide_addresses(lua);
    return run_original(lua);
}

int to_string(lua_State* lua) {
    luaL_checkany(lua, 1);
    push_text(lua, 1);
    return 1;
}

int to_number(lua_State* lua) {
    if (text_length(lua, 1) > longest_number) {
        luaL_pushfail(lua);
        return 1;
    }
    return run_original(lua);
}

constexpr char format_key = 0;

}  // namespace

void push_text(lua_State* lua, int index) {
    index = lua_absindex(lua, index);
    const int type = lua_type(lua, index);
    const bool has_address = type == LUA_TTABLE || type == LUA_TFUNCTION || type == LUA_TUSERDATA ||
                             type == LUA_TTHREAD || type == LUA_TLIGHTUSERDATA;
    if (luaL_callmeta(lua, index, "__tostring") != 0) {
        if (lua_isstring(lua, -1) == 0) {
            luaL_error(lua, "'__tostring' must return a string");
        }
        return;
    }
    if (!has_address) {
        luaL_tolstring(lua, index, nullptr);
        return;
    }
    std::array<char, 16> number{};
    std::snprintf(number.data(), number.size(), "%08x", disguised(lua_topointer(lua, index)));
    const bool named = luaL_getmetafield(lua, index, "__name") == LUA_TSTRING;
    lua_pushfstring(
        lua, "%s: %s", named ? lua_tostring(lua, -1) : lua_typename(lua, type), number.data()
    );
}

void push_formatted(lua_State* lua, int first) {
    const int arguments = lua_gettop(lua) - first + 1;
    lua_rawgetp(lua, LUA_REGISTRYINDEX, &format_key);
    lua_insert(lua, first);
    lua_call(lua, arguments, 1);
}

void charge_for_texts(lua_State* library) {
    for (const char* const name :
         {"codepoint", "codes", "len", "offset", "pack", "packsize", "unpack"}) {
        charge(library, name, charged);
    }
}

void replace_text_functions(lua_State* string) {
    for (const char* const name : {"find", "gmatch", "gsub", "match"}) {
        charge(string, name, charged_search);
    }
    for (const char* const name : {"pack", "packsize", "unpack"}) {
        charge(string, name, charged);
    }
    charge(string, "format", format);
    // Scripts may replace string.format; the log goes on with this one.
    lua_getfield(string, -1, "format");
    lua_rawsetp(string, LUA_REGISTRYINDEX, &format_key);
}

void replace_conversions(lua_State* globals) {
    lua_pushcfunction(globals, to_string);
    lua_setfield(globals, -2, "tostring");
    charge(globals, "tonumber", to_number);
}

}  // namespace hyrax::script
