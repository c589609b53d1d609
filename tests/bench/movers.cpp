// SPDX-License-Identifier: MIT
#include "tests/bench/movers.h"

#include <algorithm>

namespace hyrax::bench {

BodyScene box_scene(const PhysicsConstants& constants, Size room, Vec2 at, Vec2 velocity) {
    return {
        .name = {},
        .constants = constants,
        .law = law_from(constants),
        .space = FreeSpace::box(0.0, 0.0, room.width, room.height),
        .room = room,
        .at = at,
        .velocity = velocity,
    };
}

std::string_view name_of(Method method) {
    return methods[static_cast<std::size_t>(method)].name;
}

std::optional<Method> method_named(std::string_view name) {
    const auto found = std::ranges::find(methods, name, &NamedMethod::name);
    return found == methods.end() ? std::nullopt : std::optional(found->method);
}

DocumentMover::DocumentMover(const BodyScene& scene)
    : body_(scene.at.x, scene.at.y, scene.velocity.x, scene.velocity.y), room_(scene.room) {
    body_.setConstants(scene.constants);
}

}  // namespace hyrax::bench
