// SPDX-License-Identifier: MIT
#include "daemon/script/arguments.h"

#include "daemon/core/nearest_name.h"
#include "daemon/script/text.h"

#include <fmt/format.h>
#include <lauxlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyrax::script {
namespace {

constexpr double longest_wait = 365.0 * 24.0 * 3600.0;  // [s]
// Longer names are not repeated in a message.
constexpr std::size_t longest_name = 64;

[[noreturn]] void wrong_type(lua_State* lua, int index, const char* what, const char* expected) {
    raise_error(
        lua, fmt::format("{} must be {}, got {}", what, expected, luaL_typename(lua, index))
    );
}

}  // namespace

void raise_error(lua_State* lua, const std::string& message) {
    luaL_where(lua, 1);
    lua_pushlstring(lua, message.data(), message.size());
    lua_concat(lua, 2);
    lua_error(lua);
    std::unreachable();
}

double number_argument(lua_State* lua, int index, const char* what) {
    if (lua_type(lua, index) != LUA_TNUMBER) {
        wrong_type(lua, index, what, "a number");
    }
    const double number = lua_tonumber(lua, index);
    if (!std::isfinite(number)) {
        raise_error(lua, fmt::format("{} must be a finite number, got {}", what, number));
    }
    return number;
}

double number_argument(lua_State* lua, int index, const char* what, double lowest, double highest) {
    const double number = number_argument(lua, index, what);
    if (number < lowest || number > highest) {
        raise_error(
            lua,
            fmt::format("{} must be from {:g} to {:g}, got {:g}", what, lowest, highest, number)
        );
    }
    return number;
}

std::string_view choice_argument(
    lua_State* lua, int index, const char* what, std::span<const std::string_view> choices
) {
    if (lua_type(lua, index) != LUA_TSTRING) {
        wrong_type(lua, index, what, "a string");
    }
    const std::string_view name(lua_tostring(lua, index), lua_rawlen(lua, index));
    const auto found = std::ranges::find(choices, name);
    if (found == choices.end()) {
        unknown_name(lua, what, "choice", name, choices);
    }
    return *found;
}

Ticks seconds_argument(lua_State* lua, int index, const char* what) {
    const double seconds = number_argument(lua, index, what);
    if (seconds < 0.0 || seconds > longest_wait) {
        raise_error(
            lua, fmt::format("{} must be from 0 to {} seconds, got {}", what, longest_wait, seconds)
        );
    }
    return from_seconds(seconds);
}

std::string text_argument(lua_State* lua, int index, const char* what, std::size_t longest) {
    if (lua_type(lua, index) != LUA_TSTRING) {
        wrong_type(lua, index, what, "a string");
    }
    const std::string_view text(lua_tostring(lua, index), lua_rawlen(lua, index));
    if (text.size() > longest) {
        raise_error(
            lua, fmt::format("{} must have at most {} bytes, got {}", what, longest, text.size())
        );
    }
    if (!is_plain_text(text)) {
        raise_error(lua, fmt::format("{} must be UTF-8 without control characters", what));
    }
    return std::string(text);
}

void require_function(lua_State* lua, int index, const char* what) {
    if (lua_type(lua, index) != LUA_TFUNCTION) {
        wrong_type(lua, index, what, "a function");
    }
}

void unknown_name(
    lua_State* lua,
    const char* what,
    const char* noun,
    std::string_view name,
    std::span<const std::string_view> known
) {
    std::string message =
        fmt::format("{}: unknown {} '{}'", what, noun, clean_text(name, longest_name));
    if (const auto nearest = nearest_name(name, known)) {
        message += fmt::format(" (did you mean '{}'?)", *nearest);
    } else if (!known.empty()) {
        message += fmt::format(" (there are: {})", fmt::join(known, ", "));
    }
    raise_error(lua, message);
}

Vec2 shortened(Vec2 velocity, double longest) {
    const double largest = std::max(std::abs(velocity.x), std::abs(velocity.y));
    if (largest <= 0.0) {
        return velocity;
    }
    // Divided first: the length of a huge vector would overflow.
    const Vec2 direction = velocity * (1.0 / largest);
    const double length = std::hypot(direction.x, direction.y);
    return largest <= longest / length ? velocity : direction * (longest / length);
}

Options::Options(
    lua_State* lua, int index, const char* function, std::span<const std::string_view> known
)
    : lua_(lua), index_(index), function_(function), given_(lua_istable(lua, index)) {
    if (!given_) {
        if (!lua_isnoneornil(lua, index)) {
            wrong_type(lua, index, fmt::format("{}: options", function).c_str(), "a table");
        }
        return;
    }
    lua_pushnil(lua);
    while (lua_next(lua, index) != 0) {
        lua_pop(lua, 1);
        if (lua_type(lua, -1) != LUA_TSTRING) {
            raise_error(
                lua,
                fmt::format(
                    "{}: options have names, got a {} as a key", function, luaL_typename(lua, -1)
                )
            );
        }
        const std::string_view name(lua_tostring(lua, -1), lua_rawlen(lua, -1));
        if (std::ranges::find(known, name) == known.end()) {
            unknown_name(lua, function, "option", name, known);
        }
    }
}

std::string Options::what(const char* name) const {
    return fmt::format("{}: {}", function_, name);
}

bool Options::push(const char* name) const {
    if (!given_) {
        return false;
    }
    lua_pushstring(lua_, name);
    if (lua_rawget(lua_, index_) == LUA_TNIL) {
        lua_pop(lua_, 1);
        return false;
    }
    return true;
}

std::optional<double> Options::number(const char* name) const {
    if (!push(name)) {
        return std::nullopt;
    }
    const double number = number_argument(lua_, -1, what(name).c_str());
    lua_pop(lua_, 1);
    return number;
}

std::optional<double> Options::number(const char* name, double lowest, double highest) const {
    if (!push(name)) {
        return std::nullopt;
    }
    const double number = number_argument(lua_, -1, what(name).c_str(), lowest, highest);
    lua_pop(lua_, 1);
    return number;
}

std::optional<std::string> Options::text(const char* name, std::size_t longest) const {
    if (!push(name)) {
        return std::nullopt;
    }
    std::string text = text_argument(lua_, -1, what(name).c_str(), longest);
    lua_pop(lua_, 1);
    return text;
}

std::optional<bool> Options::flag(const char* name) const {
    if (!push(name)) {
        return std::nullopt;
    }
    if (lua_type(lua_, -1) != LUA_TBOOLEAN) {
        wrong_type(lua_, -1, what(name).c_str(), "true or false");
    }
    const bool value = lua_toboolean(lua_, -1) != 0;
    lua_pop(lua_, 1);
    return value;
}

}  // namespace hyrax::script
