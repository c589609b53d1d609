// SPDX-License-Identifier: MIT
// The keys of config.json about hotkeys, scripts and the log.
#include "daemon/core/config_fields.h"

namespace hyrax {
namespace {

constexpr std::array<std::string_view, 6> log_levels{
    "trace", "debug", "info", "warn", "error", "off"
};

constexpr std::array script_keys{
    Field<Config>{
        "/scripts/run",
        [](Config& c) -> Slot { return &c.scripts; },
        {0, 1000},
        "",
        "Scripts to run at the start: files in the scripts folder; * and ? match any part of a "
        "name."
    },
    Field<Config>{
        "/scripts/developer",
        [](Config& c) -> Slot { return &c.developer; },
        {},
        "",
        "hyraxctl may run code in scripts and scripts of its own: run, eval and repl."
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
        "/scripts/limits/unload_units",
        [](Config& c) -> Slot { return &c.limits.unload_units; },
        {1000, 1e9},
        "units",
        "Work units that a script may spend on its unload handlers; about 0.5 ms."
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
        "/scripts/limits/store",
        [](Config& c) -> Slot { return &c.limits.store; },
        {1024, 16777216},
        "bytes",
        "What a script may keep in its store."
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
        "/plugins",
        [](Config& c) -> Slot { return &c.plugins; },
        {},
        "",
        "For each plugin, by its id: enabled, and the settings that its plugin.json declares."
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

template <UserHotkey Which>
constexpr Field<Config> hotkey_field(std::string_view path, std::string_view description) {
    return {
        path,
        [](Config& c) -> Slot { return &c.hotkeys[static_cast<std::size_t>(Which)]; },
        {},
        "",
        description
    };
}

constexpr std::array hotkey_keys{
    hotkey_field<UserHotkey::gather>(
        "/hotkeys/gather",
        "Keys such as ctrl+alt+g, which call all pets to the monitor under the pointer."
    ),
    hotkey_field<UserHotkey::hide>("/hotkeys/hide", "Hides all pets, or shows them again."),
    hotkey_field<UserHotkey::pause>("/hotkeys/pause", "Pets and scripts stand still, or go on."),
    hotkey_field<UserHotkey::quiet>("/hotkeys/quiet", "Turns quiet on or off."),
    hotkey_field<UserHotkey::click_through>(
        "/hotkeys/click_through", "Turns overlay.click_through on or off."
    ),
};

}  // namespace

std::span<const Field<Config>> hotkey_table() {
    return hotkey_keys;
}

std::span<const Field<Config>> script_table() {
    return script_keys;
}

}  // namespace hyrax
