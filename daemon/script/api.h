// SPDX-License-Identifier: MIT
// The functions and fields that scripts see, as scripts/hyrax.d.lua describes them. Each api_*.cpp
// holds one subject; open_api() puts them together.
#pragma once

#include "daemon/script/script.h"

#include <lauxlib.h>
#include <lua.h>

#include <array>
#include <concepts>
#include <exception>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hyrax::script {

/// Makes the global `hyrax` and `print`. May raise a Lua error.
void open_api(lua_State* lua);

// --- the parts: each adds to the table `hyrax` on top of the stack ---

void open_pet_api(lua_State* lua);
void open_pets_api(lua_State* lua);
void open_events_api(lua_State* lua);
void open_time_api(lua_State* lua);
void open_world_api(lua_State* lua);
void open_log_api(lua_State* lua);
void open_store_api(lua_State* lua);
void open_permitted_api(lua_State* lua);
/// For a script whose cases run.
void open_test_api(lua_State* lua);

// --- what scripts can name; a test compares it with scripts/hyrax.d.lua ---

inline constexpr std::array<std::string_view, 24> pet_members{
    "valid", "id",    "kind",    "owner",  "x",      "y",       "vx",    "vy",
    "w",     "h",     "state",   "tag",    "facing", "scale",   "fling", "push",
    "stop",  "reset", "move_to", "remove", "on",     "walk_to", "play",  "say"
};
/// Those that are read like values.
inline constexpr std::span<const std::string_view> pet_fields = std::span(pet_members).first(14);
inline constexpr std::array<std::string_view, 2> play_options{"loop", "fps"};
inline constexpr std::array<std::string_view, 7> spawn_options{
    "kind", "x", "y", "vx", "vy", "tag", "scale"
};
inline constexpr std::array<std::string_view, 4> filter_options{"kind", "tag", "all", "near"};
inline constexpr std::array<std::string_view, 3> near_options{"x", "y", "r"};

// --- handles ---

/// Pushes the handle of a pet, the same one each time. `tag` is what it reads once it is gone;
/// without one, what the handle remembers.
void push_pet(lua_State* lua, PetKey key, std::optional<std::string_view> tag);
/// Pushes what a handler of the event gets, and returns how many values that are. Of two pets, the
/// one that the handler is about comes first.
int push_event(lua_State* lua, const ScriptEvent& event, PetKey subject);
/// The same without that pet, for wait_for; `true` where nothing would be left.
int push_outcome(lua_State* lua, const ScriptEvent& event, PetKey subject);
/// Lets go of handles of pets that are gone. Needs no memory and raises nothing.
void forget_handles(lua_State* lua, const WorldView& view);

/// The pet at `index`, which may be gone. Raises an error if it is no pet. `what`: "pet:fling".
PetKey pet_argument(lua_State* lua, int index, const char* what);
/// Raises an error if the pet is gone, or belongs to somebody else and must be left alone.
const PetView& writable_pet(lua_State* lua, Script& script, PetKey key, const char* what);

/// Pushes a handle whose cancel() ends the handler or timer.
void push_subscription(lua_State* lua, std::uint64_t id);
/// Sets a field of hyrax.config to the value on top of the stack, and pops it.
void set_config(lua_State* lua, const std::string& key);

/// Adds a handler for the function at `function` and pushes its subscription.
int add_handler(lua_State* lua, Script& script, Topic topic, PetKey pet, int function);
/// The event named at `index`. Raises an error if there is none.
Topic topic_argument(lua_State* lua, int index, const char* what);

/// Pushes a table { x, y, w, h }.
void push_rect(lua_State* lua, const Rect& rect);

// --- how pets look and walk: api_looks.cpp ---

int pet_walk_to(lua_State* lua, Script& script);
int pet_play(lua_State* lua, Script& script);
int pet_say(lua_State* lua, Script& script);
/// The new value is the third argument.
void set_scale(lua_State* lua, Script& script, PetKey key);
void set_facing(lua_State* lua, Script& script, PetKey key);

// --- verbs, for one pet and for many ---

void fling(lua_State* lua, Script& script, PetKey pet, Vec2 velocity);
void reset(lua_State* lua, Script& script, PetKey pet);
void remove(lua_State* lua, Script& script, PetKey pet);

using ApiFunction = int (*)(lua_State*, Script&);

/// About the cost of the shortest function, 50 ns.
inline constexpr std::int64_t call_units = 20;

/// A function of the API as Lua calls it: charged for, and with C++ exceptions turned into errors.
/// Lua's own errors are exceptions too, of a type of their own, and must pass.
template <ApiFunction function>
int api(lua_State* lua) {
    Script& script = Script::of(lua);
    script.meter.charge(lua, call_units);
    try {
        return function(lua, script);
    } catch (const std::exception& problem) {
        return luaL_error(lua, "%s", problem.what());
    }
}

}  // namespace hyrax::script
