// SPDX-License-Identifier: MIT
// hyrax.test: cases that a script brings for itself.
#include "daemon/script/api.h"

#include "daemon/script/arguments.h"
#include "daemon/script/sandbox.h"
#include "daemon/script/text.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

namespace hyrax::script {
namespace {

constexpr std::size_t most_cases = 1'000;
constexpr std::size_t longest_message = 200;

std::string shown(lua_State* lua, int index) {
    push_text(lua, index);
    const std::string_view text(lua_tostring(lua, -1), lua_rawlen(lua, -1));
    std::string clean = clean_text(text, longest_message);
    lua_pop(lua, 1);
    return lua_type(lua, index) == LUA_TSTRING ? "'" + clean + "'" : clean;
}

// What went wrong, behind what the case says of it.
[[noreturn]] void fail(lua_State* lua, int message, const std::string& problem) {
    const bool told = !lua_isnoneornil(lua, message);
    raise_error(lua, told ? shown(lua, message) + ": " + problem : problem);
}

int test_case(lua_State* lua, Script& script) {
    std::string name = text_argument(lua, 1, "hyrax.test.case: name", longest_message);
    require_function(lua, 2, "hyrax.test.case: fn");
    if (script.tests.open() >= most_cases) {
        return luaL_error(
            lua, "limit of %d cases of one script reached", static_cast<int>(most_cases)
        );
    }
    lua_pushvalue(lua, 2);
    script.tests.add(std::move(name), script.keep(lua));
    return 0;
}

int expect(lua_State* lua, Script& /*script*/) {
    luaL_checkany(lua, 1);
    if (lua_toboolean(lua, 1) == 0) {
        fail(lua, 2, "expected something true, got " + shown(lua, 1));
    }
    return 0;
}

int equal(lua_State* lua, Script& /*script*/) {
    luaL_checkany(lua, 2);
    if (lua_rawequal(lua, 1, 2) == 0) {
        fail(lua, 3, fmt::format("expected {}, got {}", shown(lua, 2), shown(lua, 1)));
    }
    return 0;
}

int near(lua_State* lua, Script& /*script*/) {
    const double actual = number_argument(lua, 1, "hyrax.test.near: actual");
    const double expected = number_argument(lua, 2, "hyrax.test.near: expected");
    const double tolerance =
        lua_isnoneornil(lua, 3) ? 1e-6 : number_argument(lua, 3, "hyrax.test.near: tolerance");
    if (!(std::abs(actual - expected) <= tolerance)) {
        fail(lua, 4, fmt::format("expected {} +- {}, got {}", expected, tolerance, actual));
    }
    return 0;
}

// The function must raise an error, in whose text `part` is.
int fails(lua_State* lua, Script& script) {
    require_function(lua, 1, "hyrax.test.fails: fn");
    const std::string part = lua_isnoneornil(lua, 2)
                                 ? ""
                                 : text_argument(lua, 2, "hyrax.test.fails: part", longest_message);
    lua_pushvalue(lua, 1);
    const int status = lua_pcall(lua, 0, 0, 0);
    script.meter.check(lua);
    if (status == LUA_OK) {
        fail(lua, 3, "expected an error, got none");
    }
    if (const std::string text = shown(lua, -1); !text.contains(part)) {
        fail(lua, 3, fmt::format("expected an error with '{}', got {}", part, text));
    }
    return 0;
}

int advance(lua_State* lua, Script& script) {
    const Ticks delay = seconds_argument(lua, 1, "hyrax.test.advance: seconds");
    return script.park(lua, {.due = script.now() + std::max(delay, shortest_period)});
}

}  // namespace

void open_test_api(lua_State* lua) {
    constexpr luaL_Reg functions[] = {
        {"advance", api<advance>},
        {"case", api<test_case>},
        {"equal", api<equal>},
        {"expect", api<expect>},
        {"fails", api<fails>},
        {"near", api<near>},
        {nullptr, nullptr},
    };
    luaL_newlib(lua, functions);
    lua_setfield(lua, -2, "test");
}

}  // namespace hyrax::script
