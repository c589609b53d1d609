// SPDX-License-Identifier: MIT
// How a pet looks and walks: its scale, the way it faces, animations, speech.
#include "daemon/script/api.h"
#include "daemon/script/arguments.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hyrax::script {
namespace {

constexpr double walking_speed = 120.0;  // [px/s]
constexpr double slowest_walk = 1.0;     // [px/s]
constexpr double shortest_speech = 0.1;  // [s]
constexpr double usual_speech = 3.0;

constexpr std::array<std::string_view, 2> sides{"left", "right"};

void check_animation(
    lua_State* lua, const Script& script, const PetView& pet, std::string_view animation
) {
    const std::vector<Kind>& kinds = script.view.world().kinds;
    const auto kind = std::ranges::find(kinds, pet.kind, &Kind::name);
    if (kind == kinds.end() || kind->animations.empty() ||
        std::ranges::find(kind->animations, animation) != kind->animations.end()) {
        return;
    }
    const std::vector<std::string_view> known(kind->animations.begin(), kind->animations.end());
    unknown_name(lua, "pet:play", "animation", animation, known);
}

}  // namespace

int pet_walk_to(lua_State* lua, Script& script) {
    const double x = number_argument(lua, 2, "pet:walk_to: x");
    const double speed =
        lua_isnoneornil(lua, 3)
            ? walking_speed
            : number_argument(lua, 3, "pet:walk_to: speed", slowest_walk, script.limits.max_speed);
    const PetKey key = pet_argument(lua, 1, "pet:walk_to");
    writable_pet(lua, script, key, "pet:walk_to");
    script.command(lua, command::WalkTo{key, x, speed});
    PetView& pet = *script.view.edit(key);
    if (pet.state == "idle" || pet.state == "walk") {
        pet.state = "walk";
        pet.velocity = {x < pet.position.x ? -speed : speed, 0.0};
        pet.faces_left = x < pet.position.x;
    }
    return 0;
}

int pet_play(lua_State* lua, Script& script) {
    std::string animation = text_argument(lua, 2, "pet:play: animation", script.limits.name);
    const Options options(lua, 3, "pet:play", play_options);
    const auto loop = options.flag("loop");
    const auto fps = options.number("fps", least_fps, most_fps);
    const PetKey key = pet_argument(lua, 1, "pet:play");
    check_animation(lua, script, writable_pet(lua, script, key, "pet:play"), animation);
    script.command(lua, command::Play{key, std::move(animation), loop, fps});
    return 0;
}

int pet_say(lua_State* lua, Script& script) {
    std::string text = text_argument(lua, 2, "pet:say: text", script.limits.speech);
    const double seconds =
        lua_isnoneornil(lua, 3)
            ? usual_speech
            : number_argument(lua, 3, "pet:say: seconds", shortest_speech, longest_speech);
    const PetKey key = pet_argument(lua, 1, "pet:say");
    writable_pet(lua, script, key, "pet:say");
    script.command(lua, command::Say{key, std::move(text), seconds});
    return 0;
}

void set_scale(lua_State* lua, Script& script, PetKey key) {
    const double scale = number_argument(lua, 3, "pet.scale", least_scale, most_scale);
    writable_pet(lua, script, key, "pet.scale");
    script.command(lua, command::SetScale{key, scale});
    script.view.edit(key)->scale = scale;
}

void set_facing(lua_State* lua, Script& script, PetKey key) {
    const bool left = choice_argument(lua, 3, "pet.facing", sides) == sides.front();
    writable_pet(lua, script, key, "pet.facing");
    script.command(lua, command::Face{key, left});
    script.view.edit(key)->faces_left = left;
}

}  // namespace hyrax::script
