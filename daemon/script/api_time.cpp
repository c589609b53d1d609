// SPDX-License-Identifier: MIT
// Time: timers, waits and tasks.
#include "daemon/script/api.h"
#include "daemon/script/arguments.h"

#include <algorithm>

namespace hyrax::script {
namespace {

// A script that waits for nothing again and again would never let the daemon sleep.
Ticks due_after(const Script& script, Ticks delay) {
    return script.now() + std::max(delay, shortest_period);
}

int add_timer(lua_State* lua, Script& script, Ticks delay, Ticks period) {
    if (script.schedule.timers().size() >= script.limits.timers) {
        return luaL_error(
            lua, "limit of %d timers of one script reached", static_cast<int>(script.limits.timers)
        );
    }
    lua_pushvalue(lua, 2);
    const int function = script.keep(lua);
    const Timer timer{.due = due_after(script, delay), .period = period, .function = function};
    push_subscription(lua, script.schedule.add(timer));
    return 1;
}

int after(lua_State* lua, Script& script) {
    const Ticks delay = seconds_argument(lua, 1, "hyrax.after: seconds");
    require_function(lua, 2, "hyrax.after: fn");
    return add_timer(lua, script, delay, 0);
}

int every(lua_State* lua, Script& script) {
    const Ticks period = seconds_argument(lua, 1, "hyrax.every: seconds");
    if (period < shortest_period) {
        return luaL_error(lua, "hyrax.every: seconds must be at least 1/120");
    }
    require_function(lua, 2, "hyrax.every: fn");
    return add_timer(lua, script, period, period);
}

int wait(lua_State* lua, Script& script) {
    const Ticks delay = seconds_argument(lua, 1, "hyrax.wait: seconds");
    return script.park(lua, {.due = due_after(script, delay)});
}

int task(lua_State* lua, Script& script) {
    require_function(lua, 1, "hyrax.task: fn");
    script.start(lua, lua_gettop(lua) - 1);
    return 0;
}

}  // namespace

void open_time_api(lua_State* lua) {
    constexpr luaL_Reg functions[] = {
        {"after", api<after>},
        {"every", api<every>},
        {"task", api<task>},
        {"wait", api<wait>},
        {nullptr, nullptr},
    };
    luaL_setfuncs(lua, functions, 0);
}

}  // namespace hyrax::script
