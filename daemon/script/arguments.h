// SPDX-License-Identifier: MIT
// Arguments of the API: read raw, without running code of the script; what is wrong is an error
// that names the function and the argument.
#pragma once

#include "physics/geometry.h"
#include "physics/ticks.h"

#include <lua.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hyrax::script {

/// Raises an error that begins with the place of the script's call.
[[noreturn]] void raise_error(lua_State* lua, const std::string& message);

/// A finite number. `what` is "pet:fling: vx".
double number_argument(lua_State* lua, int index, const char* what);
/// The same within two bounds, both included.
double number_argument(lua_State* lua, int index, const char* what, double lowest, double highest);
/// One of the names.
std::string_view choice_argument(
    lua_State* lua, int index, const char* what, std::span<const std::string_view> choices
);
/// Seconds from 0 to a year, as ticks.
Ticks seconds_argument(lua_State* lua, int index, const char* what);
/// UTF-8 without control characters, at most `longest` bytes.
std::string text_argument(lua_State* lua, int index, const char* what, std::size_t longest);
void require_function(lua_State* lua, int index, const char* what);

/// Raises `what: unknown <noun> 'bounse' (did you mean 'bounce'?)`.
[[noreturn]] void unknown_name(
    lua_State* lua,
    const char* what,
    const char* noun,
    std::string_view name,
    std::span<const std::string_view> known
);

/// As the engine does: a longer velocity keeps its direction. [px/s]
Vec2 shortened(Vec2 velocity, double longest);

/// A table of options, in which an unknown key is an error.
class Options {
public:
    /// `function` is "hyrax.spawn". No table: every option is absent.
    Options(
        lua_State* lua, int index, const char* function, std::span<const std::string_view> known
    );

    std::optional<double> number(const char* name) const;
    std::optional<std::string> text(const char* name, std::size_t longest) const;
    std::optional<double> number(const char* name, double lowest, double highest) const;
    std::optional<bool> flag(const char* name) const;
    /// Pushes the value; false (and nothing pushed) if there is none.
    bool push(const char* name) const;

private:
    std::string what(const char* name) const;

    lua_State* lua_;
    int index_;
    const char* function_;
    bool given_;
};

}  // namespace hyrax::script
