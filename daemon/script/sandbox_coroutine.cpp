// SPDX-License-Identifier: MIT
// Coroutines of scripts. They let hyrax.wait pass: whoever resumed the coroutine that waits waits
// with it, up to the host.
#include "daemon/script/sandbox.h"
#include "daemon/script/script.h"

#include <lauxlib.h>

#include <string_view>

namespace hyrax::script {
namespace {

enum class Outcome { values, error, waits };

struct Resumed {
    Outcome outcome = Outcome::values;
    int values = 0;  ///< On the resumer's stack.
};

lua_State* coroutine_argument(lua_State* lua) {
    lua_State* const thread = lua_tothread(lua, 1);
    luaL_argexpected(lua, thread != nullptr, 1, "coroutine");
    return thread;
}

Resumed fail(lua_State* lua, const char* message) {
    lua_pushstring(lua, message);
    return {Outcome::error, 1};
}

Resumed resume(lua_State* lua, lua_State* thread, int arguments) {
    Script& script = Script::of(lua);
    script.meter.check(lua);
    if (script.is_waiting(thread)) {
        lua_pop(lua, arguments);
        return fail(lua, "cannot resume a coroutine that is in hyrax.wait");
    }
    if (lua_checkstack(thread, arguments) == 0) {
        lua_pop(lua, arguments);
        return fail(lua, "too many arguments to resume");
    }
    lua_xmove(lua, thread, arguments);
    int results = 0;
    const int status = lua_resume(thread, lua, arguments, &results);
    script.meter.check(lua);
    if (status == LUA_YIELD && script.parked()) {
        lua_pop(thread, results);
        if (lua_isyieldable(lua) != 0) {
            return {Outcome::waits, 0};
        }
        script.unpark();
        return fail(
            lua,
            "cannot wait here: a coroutine was resumed inside a sort comparator, a "
            "gsub callback or a metamethod"
        );
    }
    if (status != LUA_OK && status != LUA_YIELD) {
        lua_xmove(thread, lua, 1);
        return {Outcome::error, 1};
    }
    if (lua_checkstack(lua, results + 1) == 0) {
        lua_pop(thread, results);
        return fail(lua, "too many results to resume");
    }
    lua_xmove(thread, lua, results);
    return {Outcome::values, results};
}

// The stack is the coroutine, then the arguments. `wraps`: a function of coroutine.wrap.
int resume_and_answer(lua_State* lua, bool wraps);

int go_on(lua_State* lua, int /*status*/, lua_KContext wraps) {
    Script::of(lua).waits_inside(lua_tothread(lua, 1), false);
    return resume_and_answer(lua, wraps != 0);
}

// The error is on top of the stack; closing the coroutine may replace it.
int raise_from(lua_State* lua, lua_State* thread) {
    const int status = lua_status(thread);
    if (status != LUA_OK && status != LUA_YIELD) {
        lua_closethread(thread, lua);
        Script::of(lua).meter.check(lua);
        lua_xmove(thread, lua, 1);
    }
    if (status != LUA_ERRMEM && lua_type(lua, -1) == LUA_TSTRING) {
        luaL_where(lua, 1);
        const std::string_view where(lua_tostring(lua, -1), lua_rawlen(lua, -1));
        const std::string_view message(lua_tostring(lua, -2), lua_rawlen(lua, -2));
        lua_insert(lua, -2);
        // Once is enough, however deep the recursion was.
        if (!message.starts_with(where)) {
            lua_concat(lua, 2);
        }
    }
    return lua_error(lua);
}

int resume_and_answer(lua_State* lua, bool wraps) {
    lua_State* const thread = lua_tothread(lua, 1);
    const Resumed resumed = resume(lua, thread, lua_gettop(lua) - 1);
    if (resumed.outcome == Outcome::waits) {
        Script::of(lua).waits_inside(thread, true);
        return lua_yieldk(lua, 0, wraps ? 1 : 0, go_on);
    }
    if (wraps) {
        return resumed.outcome == Outcome::error ? raise_from(lua, thread) : resumed.values;
    }
    lua_pushboolean(lua, resumed.outcome == Outcome::values ? 1 : 0);
    lua_insert(lua, -(resumed.values + 1));
    return resumed.values + 1;
}

int script_resume(lua_State* lua) {
    coroutine_argument(lua);
    return resume_and_answer(lua, false);
}

// A new coroutine starts a count of instructions of its own; chains of short ones would never be
// counted.
int script_create(lua_State* lua) {
    Script::of(lua).meter.charge(lua, Meter::period);
    luaL_checktype(lua, 1, LUA_TFUNCTION);
    lua_State* const thread = lua_newthread(lua);
    lua_pushvalue(lua, 1);
    lua_xmove(lua, thread, 1);
    return 1;
}

int call_wrapped(lua_State* lua) {
    lua_pushvalue(lua, lua_upvalueindex(1));
    lua_insert(lua, 1);
    return resume_and_answer(lua, true);
}

int script_wrap(lua_State* lua) {
    script_create(lua);
    lua_pushcclosure(lua, call_wrapped, 1);
    return 1;
}

int script_yield(lua_State* lua) {
    Script& script = Script::of(lua);
    script.meter.check(lua);
    if (script.is_host_thread(lua)) {
        return luaL_error(lua, "attempt to yield outside a coroutine (hyrax.wait waits anywhere)");
    }
    return lua_yield(lua, lua_gettop(lua));
}

int script_is_yieldable(lua_State* lua) {
    lua_State* const thread = lua_isthread(lua, 1) ? lua_tothread(lua, 1) : lua;
    const bool host = Script::of(lua).is_host_thread(thread);
    lua_pushboolean(lua, lua_isyieldable(thread) != 0 && !host ? 1 : 0);
    return 1;
}

int script_close(lua_State* lua) {
    Script& script = Script::of(lua);
    lua_State* const thread = coroutine_argument(lua);
    script.meter.charge(lua, Meter::period);
    if (script.is_waiting(thread)) {
        return luaL_error(lua, "cannot close a coroutine that is in hyrax.wait");
    }
    lua_Debug call{};
    const bool is_running = lua == thread;
    const bool resumed_another =
        lua_status(thread) == LUA_OK && lua_getstack(thread, 0, &call) != 0;
    if (is_running || resumed_another) {
        return luaL_error(lua, "cannot close a %s coroutine", is_running ? "running" : "normal");
    }
    const int status = lua_closethread(thread, lua);
    script.meter.check(lua);
    lua_pushboolean(lua, status == LUA_OK ? 1 : 0);
    if (status == LUA_OK) {
        return 1;
    }
    lua_xmove(thread, lua, 1);
    return 2;
}

}  // namespace

void replace_coroutines(lua_State* coroutine) {
    constexpr luaL_Reg functions[] = {
        {"close", script_close},
        {"create", script_create},
        {"isyieldable", script_is_yieldable},
        {"resume", script_resume},
        {"wrap", script_wrap},
        {"yield", script_yield},
        {nullptr, nullptr},
    };
    luaL_setfuncs(coroutine, functions, 0);
}

}  // namespace hyrax::script
