// SPDX-License-Identifier: MIT
// Events: handlers, subscriptions and what handlers are given.
#include "daemon/script/api.h"
#include "daemon/script/arguments.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace hyrax::script {
namespace {

constexpr char subscription_type[] = "subscription";

constexpr std::array<const char*, 4> side_names{"left", "right", "top", "bottom"};
constexpr std::array<const char*, 3> button_names{"left", "right", "middle"};

struct SubscriptionHandle {
    std::uint64_t id;
};

int subscription_cancel(lua_State* lua, Script& script) {
    const auto* const handle =
        static_cast<SubscriptionHandle*>(luaL_testudata(lua, 1, subscription_type));
    if (handle == nullptr) {
        return luaL_error(
            lua,
            "subscription:cancel: expected a subscription, got %s (methods are "
            "called with a colon)",
            luaL_typename(lua, 1)
        );
    }
    const Handler* const handler = script.schedule.handler(handle->id);
    if (handler != nullptr && handler->topic == Topic::hotkey) {
        script.command(lua, command::Hotkey{script.name(), handle->id, "", ""});
    }
    if (const auto function = script.schedule.cancel(handle->id)) {
        script.release(*function);
    }
    return 0;
}

int on(lua_State* lua, Script& script) {
    const Topic topic = topic_argument(lua, 1, "hyrax.on");
    require_function(lua, 2, "hyrax.on: fn");
    return add_handler(lua, script, topic, 0, 2);
}

// What an event tells beside the pets.
int push_details(lua_State* lua, const Event& event) {
    switch (event.kind) {
        case EventKind::throw_pet:
            lua_pushnumber(lua, event.velocity.x);
            lua_pushnumber(lua, event.velocity.y);
            return 2;
        case EventKind::bounce:
            lua_pushstring(lua, side_names[std::to_underlying(event.side)]);
            lua_pushnumber(lua, event.speed);
            return 2;
        case EventKind::land:
            lua_pushnumber(lua, event.speed);
            return 1;
        case EventKind::click:
            lua_pushstring(lua, button_names[std::to_underlying(event.button)]);
            return 1;
        case EventKind::collide:
            lua_pushnumber(lua, event.speed);
            return 1;
        case EventKind::spawn:
        case EventKind::remove:
        case EventKind::grab:
        case EventKind::monitors:
            return 0;
    }
    std::unreachable();
}

int wait_for(lua_State* lua, Script& script) {
    const Topic topic = topic_argument(lua, 2, "hyrax.wait_for");
    if (!is_about_pets(topic)) {
        return luaL_error(lua, "hyrax.wait_for: '%s' is not about a pet", lua_tostring(lua, 2));
    }
    Waiter waiter{.topic = topic};
    if (!lua_isnoneornil(lua, 3)) {
        const Ticks timeout = seconds_argument(lua, 3, "hyrax.wait_for: timeout");
        waiter.due = script.now() + std::max(timeout, shortest_period);
    }
    waiter.pet = pet_argument(lua, 1, "hyrax.wait_for");
    if (script.view.find(waiter.pet) == nullptr) {
        lua_pushnil(lua);
        return 1;
    }
    return script.park(lua, waiter);
}

// It may be gone: removed by somebody after the event, or by a handler just now.
void push_met_pet(lua_State* lua, const ScriptEvent& event, PetKey key) {
    if (const PetView* const pet = Script::of(lua).view.find(key)) {
        push_pet(lua, key, pet->tag);
    } else if (event.event.kind == EventKind::remove) {
        push_pet(lua, key, event.event.tag);
    } else {
        push_pet(lua, key, std::nullopt);
    }
}

}  // namespace

Topic topic_argument(lua_State* lua, int index, const char* what) {
    if (lua_type(lua, index) != LUA_TSTRING) {
        luaL_error(lua, "%s: event must be a string, got %s", what, luaL_typename(lua, index));
    }
    const std::string_view name(lua_tostring(lua, index), lua_rawlen(lua, index));
    const auto found = std::ranges::find(topic_names, name);
    if (found == topic_names.end()) {
        unknown_name(lua, what, "event", name, topic_names);
    }
    return static_cast<Topic>(std::distance(topic_names.begin(), found));
}

void push_subscription(lua_State* lua, std::uint64_t id) {
    auto* const handle =
        static_cast<SubscriptionHandle*>(lua_newuserdatauv(lua, sizeof(SubscriptionHandle), 0));
    handle->id = id;
    luaL_setmetatable(lua, subscription_type);
}

int add_handler(lua_State* lua, Script& script, Topic topic, PetKey pet, int function) {
    if (script.schedule.handlers().size() >= script.limits.handlers) {
        return luaL_error(
            lua,
            "limit of %d handlers of one script reached",
            static_cast<int>(script.limits.handlers)
        );
    }
    lua_pushvalue(lua, function);
    const int kept = script.keep(lua);
    const Handler handler{.topic = topic, .pet = pet, .function = kept};
    push_subscription(lua, script.schedule.add(handler, script.now()));
    return 1;
}

int push_event(lua_State* lua, const ScriptEvent& event, PetKey subject) {
    if (!is_about_pets(topic_of(event.event.kind))) {
        return push_details(lua, event.event);
    }
    if (event.other == 0) {
        push_met_pet(lua, event, event.pet);
        return 1 + push_details(lua, event.event);
    }
    const bool swapped = subject == event.other;
    push_met_pet(lua, event, swapped ? event.other : event.pet);
    push_met_pet(lua, event, swapped ? event.pet : event.other);
    return 2 + push_details(lua, event.event);
}

int push_outcome(lua_State* lua, const ScriptEvent& event, PetKey subject) {
    int details = 0;
    if (event.other != 0) {
        push_met_pet(lua, event, subject == event.other ? event.pet : event.other);
        details = 1;
    }
    details += push_details(lua, event.event);
    if (details == 0) {
        lua_pushboolean(lua, 1);
        return 1;
    }
    return details;
}

void open_events_api(lua_State* lua) {
    constexpr luaL_Reg methods[] = {{"cancel", api<subscription_cancel>}, {nullptr, nullptr}};
    luaL_newmetatable(lua, subscription_type);
    luaL_newlib(lua, methods);
    lua_setfield(lua, -2, "__index");
    lua_pushboolean(lua, 0);
    lua_setfield(lua, -2, "__metatable");
    lua_pop(lua, 1);

    constexpr luaL_Reg functions[] = {
        {"on", api<on>}, {"wait_for", api<wait_for>}, {nullptr, nullptr}
    };
    luaL_setfuncs(lua, functions, 0);
}

}  // namespace hyrax::script
