// SPDX-License-Identifier: MIT
// Lua's side of a script: state, coroutines, errors. When they run is decided in script_run.cpp.
#include "daemon/script/script.h"

#include "daemon/script/api.h"
#include "daemon/script/sandbox.h"

#include <fmt/format.h>
#include <lauxlib.h>

#include <algorithm>
#include <new>
#include <string_view>
#include <utility>

namespace hyrax::script {
namespace {

// What a new coroutine costs: it also starts a count of instructions of its own, which a short one
// never fills.
constexpr std::int64_t coroutine_units = Meter::period;

// What errors belong to while no case of hyrax.test runs.
constexpr char outside_of_cases[] = "outside of cases";

constexpr std::uint64_t splitmix(std::uint64_t& state) {
    state += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
}

// FNV-1a: unlike std::hash the same everywhere.
std::uint64_t hash_of(std::string_view text) {
    std::uint64_t hash = 0xCBF29CE484222325ULL;
    for (const char letter : text) {
        hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001B3ULL;
    }
    return hash;
}

std::string message_of(lua_State* lua, int index) {
    if (lua_type(lua, index) == LUA_TSTRING) {
        std::size_t length = 0;
        const char* const text = lua_tolstring(lua, index, &length);
        return {text, length};
    }
    if (lua_type(lua, index) == LUA_TNUMBER) {
        return fmt::format("{}", lua_tonumber(lua, index));
    }
    // No __tostring: it is code of the script.
    return fmt::format("the error object is a {} value", luaL_typename(lua, index));
}

}  // namespace

std::string error_text(lua_State* thread, int status) {
    // Lua catches every C++ exception, and calls those that are not its own -1.
    return status < 0 ? "internal error of the script host" : message_of(thread, -1);
}

Script::Script(const ScriptSource& source, const ScriptLimits& given)
    : limits(given),
      meter(limits),
      journal(source.name, limits),
      belongings(source),
      tests(source.testing),
      permissions_(source.permissions),
      random_(given.seed ^ hash_of(journal.script())) {
    lua_ = lua_newstate(Meter::allocate, &meter);
    if (lua_ == nullptr) {
        throw std::bad_alloc();
    }
    *static_cast<Script**>(lua_getextraspace(lua_)) = this;
}

Script::~Script() {
    close();
}

void Script::close() {
    if (lua_ != nullptr) {
        lua_close(std::exchange(lua_, nullptr));
    }
}

double Script::random_unit() {
    return static_cast<double>(splitmix(random_) >> 11U) * 0x1p-53;
}

bool Script::may(std::string_view permission) const {
    return std::ranges::find(permissions_, permission) != permissions_.end();
}

void Script::command(lua_State* lua, ScriptCommand command) {
    if (commands_ >= limits.commands) {
        luaL_error(
            lua, "limit of %d commands at one time reached", static_cast<int>(limits.commands)
        );
    }
    if (run_->output.commands.size() >= most_commands_in_all) {
        luaL_error(
            lua,
            "limit of %d commands of all scripts at one time reached",
            static_cast<int>(most_commands_in_all)
        );
    }
    ++commands_;
    run_->output.commands.push_back(std::move(command));
}

int Script::keep(lua_State* lua) {
    return luaL_ref(lua, LUA_REGISTRYINDEX);
}

void Script::release(int reference) {
    if (lua_ != nullptr) {
        luaL_unref(lua_, LUA_REGISTRYINDEX, reference);
    }
}

// Lua aborts the program on an error outside a protected call, so nothing that can fail happens
// outside.
void Script::protect(void (*body)(lua_State*, void*), void* data) {
    struct Call {
        void (*body)(lua_State*, void*);
        void* data;
    } call{body, data};
    lua_pushcfunction(lua_, [](lua_State* lua) {
        const Call* const given = static_cast<Call*>(lua_touserdata(lua, 1));
        lua_settop(lua, 0);
        given->body(lua, given->data);
        return 0;
    });
    lua_pushlightuserdata(lua_, &call);
    const int status = lua_pcall(lua_, 1, 0, 0);
    if (status != LUA_OK) {
        running_ = {};
        parked_ = false;
        if (!meter.killed()) {
            report(lua_, status);
        }
        lua_settop(lua_, 0);
    }
}

void Script::start(lua_State* lua, int arguments) {
    meter.charge(lua, coroutine_units);
    lua_State* const thread = lua_newthread(lua);
    const int anchor = keep(lua);
    tests.runs_in(thread);
    evaluations_.runs_in(thread);
    if (lua_checkstack(thread, arguments + 1) == 0) {
        luaL_error(lua, "too many arguments");
    }
    lua_xmove(lua, thread, arguments + 1);
    resume({thread, anchor}, lua, arguments);
    if (meter.killed()) {
        meter.check(lua);
    }
}

// A coroutine of a killed script is dropped, never closed: closing would run its code.
void Script::resume(HostThread thread, lua_State* from, int arguments) {
    const HostThread outer = std::exchange(running_, thread);
    int results = 0;
    const int status = lua_resume(thread.lua, from, arguments, &results);
    running_ = outer;
    if (meter.killed()) {
        return;
    }
    if (status == LUA_YIELD && std::exchange(parked_, false)) {
        lua_pop(thread.lua, results);
        return;
    }
    if (status != LUA_OK) {
        if (meter.spent()) {  // a refused allocation is what ended the call
            meter.condemn(thread.lua);
            return;
        }
        if (!end_evaluation(thread.lua, status)) {
            report(thread.lua, status);
        }
        lua_closethread(thread.lua, from);
    } else {
        end_evaluation(thread.lua, status);
    }
    if (tests.is_running(thread.lua)) {
        end_test();
    }
    luaL_unref(from, LUA_REGISTRYINDEX, thread.anchor);
}

void Script::report(lua_State* thread, int status) {
    const std::string message = error_text(thread, status);
    failed_ = true;
    if (tests.enabled() && !tests.fail(message)) {
        run_->output.tests.push_back({name(), outside_of_cases, message, 0.0});
    }
    if (journal.error(message, call_trace(thread, 0))) {
        paused_ = true;
    }
    if (status == LUA_ERRMEM) {
        lua_gc(thread, LUA_GCCOLLECT);
    }
}

int Script::park(lua_State* lua, Waiter waiter) {
    if (unloading_) {
        return luaL_error(lua, "cannot wait while the script is unloaded");
    }
    if (lua_isyieldable(lua) == 0) {
        return luaL_error(
            lua,
            "cannot wait inside a sort comparator, a gsub callback or a "
            "metamethod"
        );
    }
    if (schedule.waiters().size() >= limits.waiting) {
        return luaL_error(
            lua, "limit of %d waiting coroutines reached", static_cast<int>(limits.waiting)
        );
    }
    waiter.since = now();
    waiter.thread = running_;
    schedule.add(waiter);
    parked_ = true;
    return lua_yield(lua, 0);
}

void Script::unpark() {
    parked_ = false;
    schedule.take_waiter(schedule.waiters().back().id);
    std::erase_if(waiting_inside_, [this](const InnerWait& wait) {
        return wait.host_thread == running_.lua;
    });
}

bool Script::is_waiting(const lua_State* thread) const {
    return schedule.is_waiting(thread) ||
           std::ranges::find(waiting_inside_, thread, &InnerWait::thread) != waiting_inside_.end();
}

void Script::waits_inside(lua_State* thread, bool waits) {
    if (waits) {
        waiting_inside_.push_back({thread, running_.lua});
    } else {
        std::erase_if(waiting_inside_, [thread](const InnerWait& wait) {
            return wait.thread == thread;
        });
    }
}

}  // namespace hyrax::script
