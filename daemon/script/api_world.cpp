// SPDX-License-Identifier: MIT
// The world that pets live in: screens and time. Plain values out, so sol2 makes the functions.
#include "daemon/script/api.h"
#include "physics/geometry.h"

#include <fmt/format.h>
#include <sol/sol.hpp>

#include <vector>

namespace hyrax::script {
namespace {

sol::table rect_table(sol::state_view lua, const Rect& rect) {
    return lua.create_table_with("x", rect.x, "y", rect.y, "w", rect.width, "h", rect.height);
}

// As api() does for the functions that are written by hand.
Script& charged_script(lua_State* lua) {
    Script& script = Script::of(lua);
    script.meter.charge(lua, call_units);
    return script;
}

sol::table arena(sol::this_state lua) {
    Rect bounds;
    for (const Monitor& monitor : charged_script(lua).view.world().monitors) {
        bounds = united(bounds, monitor.work);
    }
    return rect_table(lua, bounds);
}

sol::table monitors(sol::this_state lua) {
    sol::state_view state(lua);
    sol::table list = state.create_table();
    for (const Monitor& monitor : charged_script(lua).view.world().monitors) {
        sol::table entry = rect_table(state, monitor.bounds);
        entry["work"] = rect_table(state, monitor.work);
        entry["primary"] = monitor.primary;
        entry["scale"] = monitor.scale;
        list.add(entry);
    }
    return list;
}

double now(sol::this_state lua) {
    return charged_script(lua).seconds();
}

}  // namespace

void push_rect(lua_State* lua, const Rect& rect) {
    rect_table(lua, rect).push();
}

void open_world_api(lua_State* lua) {
    sol::stack_table hyrax(lua, -1);
    hyrax["api"] = fmt::format("{}.{}", script_api_major, script_api_minor);
    // sol::c_call: the function is part of the type, so that nothing has to be stored in Lua and
    // destroyed by a finalizer.
    hyrax["arena"] = sol::c_call<decltype(&arena), &arena>;
    hyrax["monitors"] = sol::c_call<decltype(&monitors), &monitors>;
    hyrax["now"] = sol::c_call<decltype(&now), &now>;
}

}  // namespace hyrax::script
