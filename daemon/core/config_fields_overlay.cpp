// SPDX-License-Identifier: MIT
// The keys of config.json's overlay.
#include "daemon/core/config_fields.h"

namespace hyrax {
namespace {

constexpr std::array overlay_keys{
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
        "/overlay/z",
        [](Config& c) -> Slot { return Choice(c.layer); },
        {},
        "",
        "Where pets stand among all windows: above them and the taskbar (above_taskbar), above "
        "them until the taskbar comes forward (top), or below them on the wallpaper (bottom).",
        layer_names
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
        "/overlay/click_through",
        [](Config& c) -> Slot { return &c.click_through; },
        {},
        "",
        "Clicks go through pets to what lies below, so that nobody can grab them. The tray menu's "
        "choice comes first."
    },
};

}  // namespace

std::span<const Field<Config>> overlay_table() {
    return overlay_keys;
}

}  // namespace hyrax
