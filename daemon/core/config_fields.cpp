// SPDX-License-Identifier: MIT
#include "daemon/core/config_fields.h"

namespace hyrax {
namespace {

// Far beyond any desktop, and small enough that pixels still fit an int.
constexpr double most_px = 1e6;
constexpr double most_speed = 1e7;

constexpr std::array motion_keys{
    Field<Config>{
        "/$schema",
        [](Config&) -> Slot { return Ignored{}; },
        {},
        "",
        "The schema by which an editor explains and completes this file."
    },
    Field<Config>{
        "/physics/integrator",
        [](Config& c) -> Slot { return Choice(c.engine.integrator); },
        {},
        "",
        "How motion is computed. event_driven is exact at any frame rate; semi_implicit_euler is "
        "the document's law once a frame.",
        integrator_names
    },
    Field<Config>{
        "/physics/gravity",
        [](Config& c) -> Slot { return &c.engine.physics.gravity; },
        {0.0, 1e9},
        "px/s^2",
        "Downward acceleration. 0 lets pets float."
    },
    Field<Config>{
        "/physics/restitution",
        [](Config& c) -> Slot { return &c.engine.physics.restitution; },
        {0, 1},
        "",
        "Share of its speed that a pet keeps when it bounces: 0 does not bounce, 1 loses nothing."
    },
    Field<Config>{
        "/physics/air_drag",
        [](Config& c) -> Slot { return &c.engine.physics.air_drag; },
        {0, 1},
        "",
        "Share of its velocity that a pet keeps in a frame of reference_rate: 1 is a vacuum."
    },
    Field<Config>{
        "/physics/ground_friction",
        [](Config& c) -> Slot { return &c.engine.physics.ground_friction; },
        {0, 1},
        "",
        "Share of its sideways velocity that a pet keeps in a frame on the ground: 1 is ice."
    },
    Field<Config>{
        "/physics/rest_threshold",
        [](Config& c) -> Slot { return &c.engine.physics.rest_threshold; },
        {0, 1e6},
        "px/s",
        "A pet that would bounce up slower than this stays on the ground."
    },
    Field<Config>{
        "/physics/quadratic_drag",
        [](Config& c) -> Slot { return &c.engine.forces.quadratic_drag; },
        {0, 1},
        "1/px",
        "Air drag that grows with the square of the speed. Any but 0 makes rk45 the integrator."
    },
    Field<Config>{
        "/physics/reference_rate",
        [](Config& c) -> Slot { return &c.engine.reference_rate; },
        {1, 1000},
        "frames/s",
        "The frame rate that air_drag and ground_friction are meant for."
    },
    Field<Config>{
        "/physics/fixed_rate",
        [](Config& c) -> Slot { return &c.engine.fixed_rate; },
        {10, 10000},
        "steps/s",
        "Steps of semi_implicit_euler_fixed; no other integrator has any."
    },
    Field<Config>{
        "/physics/grip_frequency",
        [](Config& c) -> Slot { return &c.engine.hand.frequency; },
        {1, 1000},
        "rad/s",
        "How stiff the spring is that holds a grabbed pet on the pointer."
    },
    Field<Config>{
        "/physics/grip_damping",
        [](Config& c) -> Slot { return &c.engine.hand.damping_ratio; },
        {0, 100},
        "",
        "Damping of that spring: below 1 it swings, 1 is the quickest without swinging."
    },
    Field<Config>{
        "/pets/start",
        [](Config& c) -> Slot { return &c.start_pets; },
        {0, 1000},
        "",
        "The pets that appear when the program starts."
    },
    Field<Config>{
        "/pets/max",
        [](Config& c) -> Slot { return &c.engine.max_pets; },
        {1, 10000},
        "pets",
        "No more pets than this at a time, whoever asks for them."
    },
    Field<Config>{
        "/pets/max_spawn_rate",
        [](Config& c) -> Slot { return &c.engine.max_spawn_rate; },
        {1, 10000},
        "pets/s",
        "No more new pets a second than this, whoever asks for them."
    },
    Field<Config>{
        "/pets/max_speed",
        [](Config& c) -> Slot { return &c.engine.max_speed; },
        {1, most_speed},
        "px/s",
        "Scripts and commands set no pet faster than this."
    },
    Field<Config>{
        "/pets/max_throw_speed",
        [](Config& c) -> Slot { return &c.max_throw_speed; },
        {0, most_speed},
        "px/s",
        "The mouse throws no pet faster than this."
    },
    Field<Config>{
        "/pets/drowsy_after",
        [](Config& c) -> Slot { return &c.drowsy_after; },
        {0, 86400},
        "s",
        "A pet that has not moved for this time lies down."
    },
    Field<Config>{
        "/pets/scale",
        [](Config& c) -> Slot { return &c.engine.scale; },
        {least_scale, most_scale},
        "",
        "How large pets are, beside the scale of their kind and their own. Pixel art takes the "
        "nearest whole number."
    },
    Field<Config>{
        "/pets/scale_with_dpi",
        [](Config& c) -> Slot { return &c.engine.scale_with_dpi; },
        {},
        "",
        "Whether pets grow with the scaling that the system sets for their screen."
    },
};

constexpr std::array start_keys{
    Field<StartItem>{
        "/kind",
        [](StartItem& s) -> Slot { return &s.pets.kind; },
        {},
        "",
        "Which pet: the name of a folder of pictures in sprites."
    },
    Field<StartItem>{
        "/count",
        [](StartItem& s) -> Slot { return &s.pets.count; },
        {0, 1000},
        "pets",
        "How many of them."
    },
    Field<StartItem>{
        "/x",
        [](StartItem& s) -> Slot { return &s.x; },
        {-most_px, most_px},
        "px",
        "Left edge, from the left edge of the main screen. Without x and y: somewhere at the top."
    },
    Field<StartItem>{
        "/y",
        [](StartItem& s) -> Slot { return &s.y; },
        {-most_px, most_px},
        "px",
        "Top edge, downwards from the top edge of the main screen. Only together with x."
    },
    Field<StartItem>{
        "/vx",
        [](StartItem& s) -> Slot { return &s.pets.velocity.x; },
        {-most_speed, most_speed},
        "px/s",
        "Velocity to the right."
    },
    Field<StartItem>{
        "/vy",
        [](StartItem& s) -> Slot { return &s.pets.velocity.y; },
        {-most_speed, most_speed},
        "px/s",
        "Velocity downwards; negative values throw the pet up."
    },
};

constexpr std::array full_screen_rule_keys{
    Field<FullScreenRule>{
        "/exe",
        [](FullScreenRule& r) -> Slot { return &r.program; },
        {},
        "",
        "The program's file, such as game.exe."
    },
    Field<FullScreenRule>{
        "/do",
        [](FullScreenRule& r) -> Slot { return Choice(r.act); },
        {},
        "",
        "As in fullscreen; hide_everywhere removes every window of hyrax as long as the program is "
        "in front, full screen or not.",
        full_screen_names
    },
};

}  // namespace

std::string_view name_of(Integrator integrator) {
    return integrator_names[static_cast<std::size_t>(integrator)];
}

std::span<const Field<Config>> config_table() {
    static const std::vector<Field<Config>> all = [] {
        std::vector<Field<Config>> keys(motion_keys.begin(), motion_keys.end());
        for (const std::span<const Field<Config>> more :
             {overlay_table(), hotkey_table(), script_table()}) {
            keys.insert(keys.end(), more.begin(), more.end());
        }
        return keys;
    }();
    return all;
}

std::span<const Field<StartItem>> start_table() {
    return start_keys;
}

std::span<const Field<FullScreenRule>> full_screen_rule_table() {
    return full_screen_rule_keys;
}

}  // namespace hyrax
