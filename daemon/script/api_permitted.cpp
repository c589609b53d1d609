// SPDX-License-Identifier: MIT
// What a script may do only with a permission: see the pointer and windows, take hotkeys, notify,
// make wind.
#include "daemon/core/key_combination.h"
#include "daemon/script/api.h"
#include "daemon/script/arguments.h"

#include <fmt/format.h>

#include <chrono>
#include <string>

namespace hyrax::script {
namespace {

constexpr std::size_t longest_keys = 64;

void require_permission(
    lua_State* lua, const Script& script, const char* function, const char* permission
) {
    if (!script.may(permission)) {
        luaL_error(lua, "%s needs the permission \"%s\"", function, permission);
    }
}

int cursor(lua_State* lua, Script& script) {
    require_permission(lua, script, "hyrax.cursor", "cursor");
    const std::optional<Vec2>& at = script.view.world().cursor;
    if (!at) {
        lua_pushnil(lua);
        return 1;
    }
    lua_pushnumber(lua, at->x);
    lua_pushnumber(lua, at->y);
    return 2;
}

int windows(lua_State* lua, Script& script) {
    require_permission(lua, script, "hyrax.windows", "windows");
    const std::vector<Rect>& list = script.view.world().windows;
    lua_createtable(lua, static_cast<int>(list.size()), 0);
    for (std::size_t i = 0; i < list.size(); ++i) {
        push_rect(lua, list[i]);
        lua_rawseti(lua, -2, static_cast<lua_Integer>(i + 1));
    }
    return 1;
}

int hotkey(lua_State* lua, Script& script) {
    require_permission(lua, script, "hyrax.hotkey", "hotkeys");
    const Result<KeyCombination> keys =
        parse_keys(text_argument(lua, 1, "hyrax.hotkey: keys", longest_keys));
    if (!keys) {
        raise_error(lua, fmt::format("hyrax.hotkey: keys: {}", keys.error().message));
    }
    const std::string label = text_argument(lua, 2, "hyrax.hotkey: label", script.limits.name);
    require_function(lua, 3, "hyrax.hotkey: fn");
    add_handler(lua, script, Topic::hotkey, 0, 3);
    const std::uint64_t id = script.schedule.handlers().back().id;
    script.command(lua, command::Hotkey{script.name(), id, text_of(*keys), label});
    return 1;
}

// Nothing, or two zeros, ends it.
int wind(lua_State* lua, Script& script) {
    require_permission(lua, script, "hyrax.wind", "wind");
    Vec2 velocity;
    if (!lua_isnoneornil(lua, 1)) {
        velocity = {
            number_argument(lua, 1, "hyrax.wind: vx"),
            lua_isnoneornil(lua, 2) ? 0.0 : number_argument(lua, 2, "hyrax.wind: vy")
        };
    }
    velocity = shortened(velocity, script.limits.max_speed);
    if (velocity != script.belongings.wind) {
        script.command(lua, command::Wind{script.name(), velocity});
        script.belongings.wind = velocity;
    }
    return 0;
}

int notify(lua_State* lua, Script& script) {
    require_permission(lua, script, "hyrax.notify", "notify");
    const std::string text = text_argument(lua, 1, "hyrax.notify: text", script.limits.speech);
    const auto pause = script.limits.notice_pause;
    Ticks& next = script.belongings.next_notice;
    if (script.now() < next) {
        return luaL_error(
            lua,
            "hyrax.notify: limit of one notice in %d s reached",
            static_cast<int>(pause.count())
        );
    }
    script.command(lua, command::Notify{script.name(), text});
    next = script.now() + std::chrono::nanoseconds(pause).count();
    return 0;
}

}  // namespace

void open_permitted_api(lua_State* lua) {
    constexpr luaL_Reg functions[] = {
        {"cursor", api<cursor>},
        {"hotkey", api<hotkey>},
        {"notify", api<notify>},
        {"wind", api<wind>},
        {"windows", api<windows>},
        {nullptr, nullptr},
    };
    luaL_setfuncs(lua, functions, 0);
}

}  // namespace hyrax::script
