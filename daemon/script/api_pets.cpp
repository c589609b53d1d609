// SPDX-License-Identifier: MIT
// Many pets: spawning, finding, and verbs for all that a filter names.
#include "daemon/script/api.h"
#include "daemon/script/arguments.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hyrax::script {
namespace {

struct Circle {
    Vec2 centre;
    double radius = 0.0;
};

// A plugin calls its own kinds without its name.
std::string full_kind(const Script& script, std::string kind) {
    if (script.belongings.version.empty()) {
        return kind;
    }
    std::string own = script.name() + "/" + kind;
    const bool is_own = std::ranges::count(script.view.world().kinds, own, &Kind::name) != 0;
    return is_own ? own : kind;
}

struct Filter {
    std::optional<std::string> kind;
    std::optional<std::string> tag;
    bool all = false;
    std::optional<Circle> near;
};

std::optional<Circle> near_option(lua_State* lua, const Options& options, const char* function) {
    if (!options.push("near")) {
        return std::nullopt;
    }
    const std::string what = std::string(function) + ": near";
    if (!lua_istable(lua, -1)) {
        luaL_error(lua, "%s must be a table { x, y, r }", what.c_str());
    }
    const Options near(lua, lua_gettop(lua), what.c_str(), near_options);
    const auto x = near.number("x");
    const auto y = near.number("y");
    const auto r = near.number("r");
    if (!x || !y || !r || *r < 0.0) {
        luaL_error(lua, "%s needs x, y and r, which is not negative", what.c_str());
        return std::nullopt;
    }
    lua_pop(lua, 1);
    return Circle{{*x, *y}, *r};
}

Filter filter_argument(lua_State* lua, Script& script, int index, const char* function) {
    const Options options(lua, index, function, filter_options);
    auto kind = options.text("kind", script.limits.name);
    if (kind) {
        kind = full_kind(script, *std::move(kind));
    }
    return {
        .kind = std::move(kind),
        .tag = options.text("tag", script.limits.name),
        .all = options.flag("all").value_or(false),
        .near = near_option(lua, options, function),
    };
}

bool matches(const PetView& pet, const Filter& filter, const std::string& owner) {
    if ((!filter.all && pet.owner != owner) || (filter.kind && pet.kind != *filter.kind) ||
        (filter.tag && pet.tag != *filter.tag)) {
        return false;
    }
    if (!filter.near) {
        return true;
    }
    const Vec2 centre = pet.position + Vec2{pet.box.width / 2.0, pet.box.height / 2.0};
    const Vec2 apart = centre - filter.near->centre;
    return std::hypot(apart.x, apart.y) <= filter.near->radius;
}

std::vector<PetKey> keys_of(Script& script, const Filter& filter) {
    std::vector<PetKey> keys;
    script.view.for_each([&](const PetView& pet) {
        if (matches(pet, filter, script.name())) {
            keys.push_back(pet.key);
        }
    });
    return keys;
}

// What a verb for all may reach.
Filter everybody(const Script& script) {
    Filter filter;
    filter.all = script.may("pets.others");
    return filter;
}

Size box_of(lua_State* lua, const Script& script, const std::string& kind) {
    const std::vector<Kind>& kinds = script.view.world().kinds;
    const auto found = std::ranges::find(kinds, kind, &Kind::name);
    if (found != kinds.end()) {
        return found->box;
    }
    if (!kinds.empty()) {
        std::vector<std::string_view> names;
        for (const Kind& known : kinds) {
            names.emplace_back(known.name);
        }
        unknown_name(lua, "hyrax.spawn", "kind", kind, names);
    }
    return {};
}

// The script's side decides, so that the position can be read at once.
Vec2 entrance(Script& script, std::optional<double> x, std::optional<double> y, Size box) {
    const std::vector<Monitor>& monitors = script.view.world().monitors;
    if (monitors.empty()) {
        return {x.value_or(0.0), y.value_or(0.0)};
    }
    const double which = script.random_unit() * static_cast<double>(monitors.size());
    const Rect& work = monitors[static_cast<std::size_t>(which)].work;
    const double room = std::max(0, work.width - box.width);
    const double somewhere = work.x + std::floor(script.random_unit() * room);
    return {x.value_or(somewhere), y.value_or(work.y)};
}

int spawn(lua_State* lua, Script& script) {
    const Options options(lua, 1, "hyrax.spawn", spawn_options);
    SpawnOptions wish{
        .kind = full_kind(script, options.text("kind", script.limits.name).value_or("hyrax")),
        .at = {},
        .velocity = {options.number("vx").value_or(0.0), options.number("vy").value_or(0.0)},
        .owner = script.name(),
        .tag = options.text("tag", script.limits.name).value_or(""),
        .scale = options.number("scale", least_scale, most_scale).value_or(1.0),
    };
    const auto x = options.number("x");
    const auto y = options.number("y");
    const Size box = scaled(box_of(lua, script, wish.kind), wish.scale);
    if (keys_of(script, {}).size() >= script.limits.pets) {
        return luaL_error(
            lua,
            "hyrax.spawn: limit of %d pets of one script reached",
            static_cast<int>(script.limits.pets)
        );
    }
    wish.at = entrance(script, x, y, box);
    wish.velocity = shortened(wish.velocity, script.limits.max_speed);

    const PetKey key = script.make_key();
    script.command(lua, command::Spawn{key, wish});
    script.view.add({
        .key = key,
        .kind = wish.kind,
        .owner = wish.owner,
        .tag = wish.tag,
        .position = *wish.at,
        .velocity = wish.velocity,
        .box = box,
        .state = "fall",
        .faces_left = wish.velocity.x < 0.0,
        .scale = wish.scale,
        .spawned_at = *wish.at,
    });
    push_pet(lua, key, wish.tag);
    return 1;
}

int pets(lua_State* lua, Script& script) {
    const Filter filter = filter_argument(lua, script, 1, "hyrax.pets");
    const std::vector<PetKey> keys = keys_of(script, filter);
    lua_createtable(lua, static_cast<int>(keys.size()), 0);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        push_pet(lua, keys[i], script.view.find(keys[i])->tag);
        lua_rawseti(lua, -2, static_cast<lua_Integer>(i + 1));
    }
    return 1;
}

int pet_at(lua_State* lua, Script& script) {
    const double x = number_argument(lua, 1, "hyrax.pet_at: x");
    const double y = number_argument(lua, 2, "hyrax.pet_at: y");
    const PetView* topmost = nullptr;
    script.view.for_each([&](const PetView& pet) {
        const Vec2 inside = Vec2{x, y} - pet.position;
        if (inside.x >= 0.0 && inside.y >= 0.0 && inside.x < pet.box.width &&
            inside.y < pet.box.height) {
            topmost = &pet;
        }
    });
    if (topmost == nullptr) {
        lua_pushnil(lua);
    } else {
        push_pet(lua, topmost->key, topmost->tag);
    }
    return 1;
}

int fling_many(lua_State* lua, Script& script) {
    const Vec2 velocity{
        number_argument(lua, 2, "hyrax.fling: vx"), number_argument(lua, 3, "hyrax.fling: vy")
    };
    const Filter filter = filter_argument(lua, script, 1, "hyrax.fling");
    for (const PetKey pet : keys_of(script, filter)) {
        writable_pet(lua, script, pet, "hyrax.fling");
        fling(lua, script, pet, velocity);
    }
    return 0;
}

int reset_all(lua_State* lua, Script& script) {
    for (const PetKey pet : keys_of(script, everybody(script))) {
        reset(lua, script, pet);
    }
    return 0;
}

int clear(lua_State* lua, Script& script) {
    for (const PetKey pet : keys_of(script, everybody(script))) {
        remove(lua, script, pet);
    }
    return 0;
}

}  // namespace

void open_pets_api(lua_State* lua) {
    constexpr luaL_Reg functions[] = {
        {"clear", api<clear>},
        {"fling", api<fling_many>},
        {"pet_at", api<pet_at>},
        {"pets", api<pets>},
        {"reset", api<reset_all>},
        {"spawn", api<spawn>},
        {nullptr, nullptr},
    };
    luaL_setfuncs(lua, functions, 0);
}

}  // namespace hyrax::script
