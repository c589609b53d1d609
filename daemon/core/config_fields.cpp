// SPDX-License-Identifier: MIT
#include "daemon/core/config_fields.h"

namespace hyrax {
namespace {

constexpr std::array<std::string_view, 6> log_levels{
    "trace", "debug", "info", "warn", "error", "off"
};

// Far beyond any desktop, and small enough that pixels still fit an int.
constexpr double most_px = 1e6;
constexpr double most_speed = 1e7;

constexpr std::array config_keys{
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
    Field<Config>{
        "/overlay/fps",
        [](Config& c) -> Slot { return &c.fps; },
        {1, 1000},
        "frames/s",
        "Frames drawn while a pet moves."
    },
    Field<Config>{
        "/overlay/floor",
        [](Config& c) -> Slot { return Choice(c.floor); },
        {},
        "",
        "What pets stand on: the top of the taskbar (work_area) or the edge of the screen "
        "(screen).",
        floor_names
    },
    Field<Config>{
        "/overlay/fullscreen",
        [](Config& c) -> Slot { return Choice(c.presence.full_screen); },
        {},
        "",
        "What pets do on a screen that another program fills: hide (they wait, unseen), pause "
        "(they "
        "stand still) or stay.",
        std::span(full_screen_names).first<3>()
    },
    Field<Config>{
        "/overlay/fullscreen_rules",
        [](Config& c) -> Slot { return &c.presence.rules; },
        {0, 1000},
        "",
        "What they do instead for some programs."
    },
    Field<Config>{
        "/overlay/fps_on_battery",
        [](Config& c) -> Slot { return &c.presence.fps_on_battery; },
        {1, 1000},
        "frames/s",
        "No more frames than this on battery."
    },
    Field<Config>{
        "/overlay/fps_saving",
        [](Config& c) -> Slot { return &c.presence.fps_saving; },
        {1, 1000},
        "frames/s",
        "No more frames than this with the battery saver on, or over a remote connection."
    },
    Field<Config>{
        "/overlay/on_resume",
        [](Config& c) -> Slot { return Choice(c.presence.on_resume); },
        {},
        "",
        "After the machine slept or the screen was locked: pets go on from where they were (go_on) "
        "or are where they would have come meanwhile (catch_up, event_driven only).",
        resume_names
    },
    Field<Config>{
        "/overlay/reduced_motion",
        [](Config& c) -> Slot { return Choice(c.presence.reduced_motion); },
        {},
        "",
        "on: pets sit still unless they are thrown. auto asks the system whether animations are "
        "wanted.",
        motion_names
    },
    Field<Config>{
        "/overlay/hide_from_capture",
        [](Config& c) -> Slot { return &c.presence.hide_from_capture; },
        {},
        "",
        "Leaves pets out of screenshots, recordings and shared screens."
    },
    Field<Config>{
        "/overlay/opacity",
        [](Config& c) -> Slot { return &c.opacity; },
        {least_opacity, 1},
        "",
        "How opaque the pets are: at 1 nothing shines through them."
    },
    Field<Config>{
        "/overlay/renderer",
        [](Config& c) -> Slot { return Choice(c.renderer); },
        {},
        "",
        "Who draws the frames: hyrax itself (blit), or GDI+ (gdiplus), which is many times slower "
        "and there to compare.",
        renderer_names
    },
    Field<Config>{
        "/overlay/ledges",
        [](Config& c) -> Slot { return Choice(c.ledges); },
        {},
        "",
        "Windows whose tops pets land and rest on: none (off), the one in the foreground (active) "
        "or all.",
        ledge_names
    },
    Field<Config>{
        "/overlay/allowed_monitors",
        [](Config& c) -> Slot { return &c.allowed.monitors; },
        {0, 100},
        "",
        "Monitors that pets may be on: numbers from 1 (the primary one) or names; [] is all. The "
        "tray menu's choices come first."
    },
    Field<Config>{
        "/overlay/allowed_area",
        [](Config& c) -> Slot { return &c.allowed.area; },
        {0, 4},
        "px",
        "The part of the desktop that pets may be in: [x, y, width, height] from the top left "
        "corner of the main screen; [] is all of it."
    },
    Field<Config>{
        "/overlay/quiet",
        [](Config& c) -> Slot { return &c.quiet; },
        {},
        "",
        "Pets sit still: scripts may not move them nor spawn any, only the hand may. The tray "
        "menu's choice comes first."
    },
    Field<Config>{
        "/scripts/run",
        [](Config& c) -> Slot { return &c.scripts; },
        {0, 1000},
        "",
        "Scripts to run at the start: files in the scripts folder; * and ? match any part of a "
        "name."
    },
    Field<Config>{
        "/scripts/limits/load_units",
        [](Config& c) -> Slot { return &c.limits.load_units; },
        {1000, 1e9},
        "units",
        "Work units that a script may spend while it loads; about 50 ms."
    },
    Field<Config>{
        "/scripts/limits/callback_units",
        [](Config& c) -> Slot { return &c.limits.callback_units; },
        {1000, 1e9},
        "units",
        "Work units that each later call may spend; about 5 ms."
    },
    Field<Config>{
        "/scripts/limits/memory",
        [](Config& c) -> Slot { return &c.limits.memory; },
        {65536, 1073741824},
        "bytes",
        "Memory of one script."
    },
    Field<Config>{
        "/scripts/limits/string",
        [](Config& c) -> Slot { return &c.limits.string; },
        {1024, 67108864},
        "bytes",
        "The longest text that a script can make."
    },
    Field<Config>{
        "/scripts/limits/pets",
        [](Config& c) -> Slot { return &c.limits.pets; },
        {1, 10000},
        "pets",
        "Own pets of a script at a time."
    },
    Field<Config>{
        "/scripts/limits/timers",
        [](Config& c) -> Slot { return &c.limits.timers; },
        {1, 100000},
        "",
        "Timers of a script at a time."
    },
    Field<Config>{
        "/scripts/limits/handlers",
        [](Config& c) -> Slot { return &c.limits.handlers; },
        {1, 100000},
        "",
        "Event handlers of a script at a time."
    },
    Field<Config>{
        "/scripts/limits/waiting",
        [](Config& c) -> Slot { return &c.limits.waiting; },
        {1, 100000},
        "",
        "Coroutines of a script that wait at a time."
    },
    Field<Config>{
        "/scripts/limits/commands",
        [](Config& c) -> Slot { return &c.limits.commands; },
        {1, 10000},
        "",
        "What a script may ask of pets in one frame."
    },
    Field<Config>{
        "/scripts/limits/max_speed",
        [](Config& c) -> Slot { return &c.limits.max_speed; },
        {1, 1e7},
        "px/s",
        "Velocities that a script sets are shortened to this."
    },
    Field<Config>{
        "/scripts/limits/log_lines_per_second",
        [](Config& c) -> Slot { return &c.limits.log_lines_per_second; },
        {1, 10000},
        "lines/s",
        "Lines a second that a script may write into the log."
    },
    Field<Config>{
        "/scripts/limits/log_burst",
        [](Config& c) -> Slot { return &c.limits.log_burst; },
        {1, 10000},
        "lines",
        "Lines that a script may write at once after a silence."
    },
    Field<Config>{
        "/log/level",
        [](Config& c) -> Slot { return &c.log_level; },
        {},
        "",
        "How much the log tells, from everything (trace) to nothing (off).",
        log_levels
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
    return config_keys;
}

std::span<const Field<StartItem>> start_table() {
    return start_keys;
}

std::span<const Field<FullScreenRule>> full_screen_rule_table() {
    return full_screen_rule_keys;
}

}  // namespace hyrax
