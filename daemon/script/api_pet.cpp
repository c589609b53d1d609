// SPDX-License-Identifier: MIT
// Pets in Lua: raw userdata that hold a key, never a pointer, and need no finalizer.
#include "daemon/script/api.h"
#include "daemon/script/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace hyrax::script {
namespace {

constexpr char pet_type[] = "pet";
constexpr std::size_t longest_tag = 64;
constexpr char handles_key = 0;

struct PetHandle {
    PetKey key;
    std::size_t tag_length;
    std::array<char, longest_tag> tag;  ///< As last seen: readable when the pet is gone.
};

void remember_tag(PetHandle& handle, std::string_view tag) {
    handle.tag_length = std::min(tag.size(), longest_tag);
    std::memcpy(handle.tag.data(), tag.data(), handle.tag_length);
}

// Keys made by scripts read as small negative numbers.
lua_Integer id_of(PetKey key) {
    const auto number = static_cast<lua_Integer>(key & ~script_made_key);
    return (key & script_made_key) == 0 ? number : -number;
}

PetHandle& handle_argument(lua_State* lua, int index, const char* what) {
    void* const handle = luaL_testudata(lua, index, pet_type);
    if (handle == nullptr) {
        luaL_error(
            lua,
            "%s: expected a pet, got %s (methods are called with a colon)",
            what,
            luaL_typename(lua, index)
        );
    }
    return *static_cast<PetHandle*>(handle);
}

void push_string(lua_State* lua, std::string_view text) {
    lua_pushlstring(lua, text.data(), text.size());
}

void push_field(lua_State* lua, const PetView& pet, std::string_view field) {
    if (field == "x") {
        lua_pushnumber(lua, pet.position.x);
    } else if (field == "y") {
        lua_pushnumber(lua, pet.position.y);
    } else if (field == "vx") {
        lua_pushnumber(lua, pet.velocity.x);
    } else if (field == "vy") {
        lua_pushnumber(lua, pet.velocity.y);
    } else if (field == "w") {
        lua_pushinteger(lua, pet.box.width);
    } else if (field == "h") {
        lua_pushinteger(lua, pet.box.height);
    } else if (field == "kind") {
        push_string(lua, pet.kind);
    } else if (field == "owner") {
        push_string(lua, pet.owner);
    } else if (field == "state") {
        push_string(lua, pet.state);
    } else if (field == "scale") {
        lua_pushnumber(lua, pet.scale);
    } else {
        push_string(lua, pet.faces_left ? "left" : "right");
    }
}

// The first upvalue holds the methods.
int pet_index(lua_State* lua, Script& script) {
    PetHandle& handle = handle_argument(lua, 1, "pet");
    if (lua_type(lua, 2) != LUA_TSTRING) {
        return luaL_error(lua, "pet: fields have names, got a %s", luaL_typename(lua, 2));
    }
    lua_pushvalue(lua, 2);
    if (lua_rawget(lua, lua_upvalueindex(1)) != LUA_TNIL) {
        return 1;
    }
    const std::string_view field(lua_tostring(lua, 2), lua_rawlen(lua, 2));
    if (std::ranges::find(pet_fields, field) == pet_fields.end()) {
        unknown_name(lua, "pet", "field", field, pet_members);
    }
    const PetView* const pet = script.view.find(handle.key);
    if (field == "valid") {
        lua_pushboolean(lua, pet == nullptr ? 0 : 1);
    } else if (field == "id") {
        lua_pushinteger(lua, id_of(handle.key));
    } else if (field == "tag") {
        push_string(
            lua,
            pet == nullptr ? std::string_view(handle.tag.data(), handle.tag_length)
                           : std::string_view(pet->tag)
        );
    } else if (pet == nullptr) {
        return luaL_error(lua, "pet.%s: this pet is gone (pet.valid tells)", lua_tostring(lua, 2));
    } else {
        push_field(lua, *pet, field);
    }
    return 1;
}

// The new value is the third argument.
void set_tag(lua_State* lua, Script& script, PetHandle& handle) {
    std::string tag = text_argument(lua, 3, "pet.tag", std::min(script.limits.name, longest_tag));
    writable_pet(lua, script, handle.key, "pet.tag");
    script.command(lua, command::SetTag{handle.key, tag});
    remember_tag(handle, tag);
    script.view.edit(handle.key)->tag = std::move(tag);
}

int pet_newindex(lua_State* lua, Script& script) {
    PetHandle& handle = handle_argument(lua, 1, "pet");
    const std::string_view field = lua_type(lua, 2) == LUA_TSTRING
                                       ? std::string_view(lua_tostring(lua, 2), lua_rawlen(lua, 2))
                                       : std::string_view();
    if (field == "tag") {
        set_tag(lua, script, handle);
        return 0;
    }
    if (field == "scale") {
        set_scale(lua, script, handle.key);
        return 0;
    }
    if (field == "facing") {
        set_facing(lua, script, handle.key);
        return 0;
    }
    if (std::ranges::find(pet_fields, field) == pet_fields.end()) {
        unknown_name(lua, "pet", "field", field, pet_fields);
    }
    return luaL_error(lua, "pet.%s can only be read", lua_tostring(lua, 2));
}

int pet_eq(lua_State* lua, Script& /*script*/) {
    const auto* const a = static_cast<PetHandle*>(luaL_testudata(lua, 1, pet_type));
    const auto* const b = static_cast<PetHandle*>(luaL_testudata(lua, 2, pet_type));
    lua_pushboolean(lua, a != nullptr && b != nullptr && a->key == b->key ? 1 : 0);
    return 1;
}

int pet_tostring(lua_State* lua, Script& /*script*/) {
    lua_pushfstring(lua, "pet %I", id_of(pet_argument(lua, 1, "pet")));
    return 1;
}

int pet_fling(lua_State* lua, Script& script) {
    const Vec2 velocity{
        number_argument(lua, 2, "pet:fling: vx"), number_argument(lua, 3, "pet:fling: vy")
    };
    const PetKey pet = pet_argument(lua, 1, "pet:fling");
    writable_pet(lua, script, pet, "pet:fling");
    fling(lua, script, pet, velocity);
    return 0;
}

int pet_push(lua_State* lua, Script& script) {
    const double longest = script.limits.max_speed;
    const Vec2 given{
        number_argument(lua, 2, "pet:push: dvx"), number_argument(lua, 3, "pet:push: dvy")
    };
    const PetKey key = pet_argument(lua, 1, "pet:push");
    writable_pet(lua, script, key, "pet:push");
    const Vec2 change = shortened(given, longest);
    script.command(lua, command::Push{key, change});
    PetView& pet = *script.view.edit(key);
    pet.velocity = shortened(pet.velocity + change, longest);
    return 0;
}

int pet_stop(lua_State* lua, Script& script) {
    const PetKey pet = pet_argument(lua, 1, "pet:stop");
    writable_pet(lua, script, pet, "pet:stop");
    script.command(lua, command::Stop{pet});
    script.view.edit(pet)->velocity = {};
    return 0;
}

int pet_reset(lua_State* lua, Script& script) {
    const PetKey pet = pet_argument(lua, 1, "pet:reset");
    writable_pet(lua, script, pet, "pet:reset");
    reset(lua, script, pet);
    return 0;
}

int pet_move_to(lua_State* lua, Script& script) {
    const Vec2 position{
        number_argument(lua, 2, "pet:move_to: x"), number_argument(lua, 3, "pet:move_to: y")
    };
    const PetKey pet = pet_argument(lua, 1, "pet:move_to");
    writable_pet(lua, script, pet, "pet:move_to");
    script.command(lua, command::MoveTo{pet, position});
    script.view.edit(pet)->position = position;
    return 0;
}

int pet_remove(lua_State* lua, Script& script) {
    const PetKey pet = pet_argument(lua, 1, "pet:remove");
    if (script.view.find(pet) != nullptr) {
        writable_pet(lua, script, pet, "pet:remove");
        remove(lua, script, pet);
    }
    return 0;
}

int pet_on(lua_State* lua, Script& script) {
    const Topic topic = topic_argument(lua, 2, "pet:on");
    if (!is_about_pets(topic)) {
        return luaL_error(
            lua, "pet:on: '%s' is not about a pet; use hyrax.on", lua_tostring(lua, 2)
        );
    }
    require_function(lua, 3, "pet:on: fn");
    const PetKey pet = pet_argument(lua, 1, "pet:on");
    if (script.view.find(pet) == nullptr) {
        return luaL_error(lua, "pet:on: this pet is gone (pet.valid tells)");
    }
    return add_handler(lua, script, topic, pet, 3);
}

}  // namespace

PetKey pet_argument(lua_State* lua, int index, const char* what) {
    return handle_argument(lua, index, what).key;
}

const PetView& writable_pet(lua_State* lua, Script& script, PetKey key, const char* what) {
    const PetView* const pet = script.view.find(key);
    if (pet == nullptr) {
        luaL_error(lua, "%s: this pet is gone (pet.valid tells)", what);
    } else if (pet->owner != script.name() && !script.may("pets.others")) {
        luaL_error(
            lua,
            "%s: this pet belongs to '%s', which needs the permission \"pets.others\"",
            what,
            pet->owner.c_str()
        );
    }
    return *pet;
}

// One handle for each pet, so that it can be the key of a table.
void push_pet(lua_State* lua, PetKey key, std::optional<std::string_view> tag) {
    lua_rawgetp(lua, LUA_REGISTRYINDEX, &handles_key);
    const auto number = static_cast<lua_Integer>(key);
    if (lua_rawgeti(lua, -1, number) == LUA_TNIL) {
        lua_pop(lua, 1);
        auto* const handle = static_cast<PetHandle*>(lua_newuserdatauv(lua, sizeof(PetHandle), 0));
        handle->key = key;
        handle->tag_length = 0;
        luaL_setmetatable(lua, pet_type);
        lua_pushvalue(lua, -1);
        lua_rawseti(lua, -3, number);
    }
    if (tag) {
        remember_tag(*static_cast<PetHandle*>(lua_touserdata(lua, -1)), *tag);
    }
    lua_remove(lua, -2);
}

void forget_handles(lua_State* lua, const WorldView& view) {
    lua_rawgetp(lua, LUA_REGISTRYINDEX, &handles_key);
    if (lua_istable(lua, -1)) {
        lua_pushnil(lua);
        while (lua_next(lua, -2) != 0) {
            const PetKey key = static_cast<PetHandle*>(lua_touserdata(lua, -1))->key;
            lua_pop(lua, 1);
            if (view.is_past(key)) {
                lua_pushnil(lua);
                lua_rawseti(lua, -3, static_cast<lua_Integer>(key));
            }
        }
    }
    lua_pop(lua, 1);
}

void fling(lua_State* lua, Script& script, PetKey pet, Vec2 velocity) {
    const Vec2 possible = shortened(velocity, script.limits.max_speed);
    script.command(lua, command::Fling{pet, possible});
    script.view.edit(pet)->velocity = possible;
}

void reset(lua_State* lua, Script& script, PetKey pet) {
    script.command(lua, command::Reset{pet});
    PetView& seen = *script.view.edit(pet);
    seen.position = seen.spawned_at.value_or(seen.position);
    seen.velocity = {};
}

void remove(lua_State* lua, Script& script, PetKey pet) {
    script.command(lua, command::Remove{pet});
    script.view.remove(pet);
}

void open_pet_api(lua_State* lua) {
    constexpr luaL_Reg methods[] = {
        {"fling", api<pet_fling>},
        {"move_to", api<pet_move_to>},
        {"on", api<pet_on>},
        {"play", api<pet_play>},
        {"push", api<pet_push>},
        {"remove", api<pet_remove>},
        {"reset", api<pet_reset>},
        {"say", api<pet_say>},
        {"stop", api<pet_stop>},
        {"walk_to", api<pet_walk_to>},
        {nullptr, nullptr},
    };
    constexpr luaL_Reg metamethods[] = {
        {"__eq", api<pet_eq>},
        {"__newindex", api<pet_newindex>},
        {"__tostring", api<pet_tostring>},
        {nullptr, nullptr},
    };
    luaL_newmetatable(lua, pet_type);
    luaL_setfuncs(lua, metamethods, 0);
    luaL_newlib(lua, methods);
    lua_pushcclosure(lua, api<pet_index>, 1);
    lua_setfield(lua, -2, "__index");
    lua_pushboolean(lua, 0);
    lua_setfield(lua, -2, "__metatable");
    lua_pop(lua, 1);
    lua_newtable(lua);
    lua_rawsetp(lua, LUA_REGISTRYINDEX, &handles_key);
}

}  // namespace hyrax::script
