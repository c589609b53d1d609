// SPDX-License-Identifier: MIT
// config.json as values.
#pragma once

#include "daemon/core/allowed.h"
#include "daemon/core/arena.h"
#include "daemon/core/engine.h"
#include "daemon/core/frame.h"
#include "daemon/core/ledges.h"
#include "daemon/core/plugin_choice.h"
#include "daemon/core/presence.h"
#include "daemon/core/result.h"
#include "daemon/core/script_limits.h"
#include "daemon/core/topmost.h"
#include "daemon/core/user_hotkeys.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

/// Pets that are there when the daemon starts.
struct StartPets {
    std::string kind = "hyrax";
    int count = 1;             ///< 0 to 1000.
    std::optional<Vec2> at{};  ///< Top-left corner [px] of all of them.
    Vec2 velocity{};           ///< [px/s]
    bool operator==(const StartPets&) const = default;
};

struct Config {
    EngineSettings engine;
    std::vector<StartPets> start_pets{StartPets{}};
    double max_throw_speed = 5000.0;  ///< A hand throws no faster [px/s].
    double drowsy_after = 8.0;        ///< A still pet lies down after this time [s].
    double fps = 60.0;                ///< Frames a second while something moves, 1 to 1000.
    FloorEdge floor = FloorEdge::work_area;
    LedgeMode ledges = LedgeMode::off;
    PresenceSettings presence{};
    double opacity = 1.0;  ///< Of all pets, least_opacity to 1.
    Renderer renderer = Renderer::blit;
    Layer layer = Layer::above_taskbar;
    AllowedSettings allowed{};   ///< Where pets may be.
    bool quiet = false;          ///< Until the user says otherwise.
    bool click_through = false;  ///< Until the user says otherwise.
    UserHotkeys hotkeys{};
    ScriptLimits limits;
    std::vector<std::string> scripts{"*.lua"};  ///< Names in the scripts folder; * and ? match.
    bool developer = false;  ///< Clients of the control channel may run code in scripts.
    std::map<std::string, PluginChoice> plugins{};  ///< By id.
    std::string log_level = "info";                 ///< trace, debug, info, warn, error or off.
    bool operator==(const Config&) const = default;
};

/// As config.json spells it.
std::string_view name_of(Integrator integrator);

/// A config and what was odd about it, each line naming file, line, column and key.
struct LoadedConfig {
    Config config;
    std::vector<std::string> warnings;
};

/// One key of config.json, as it is read; config/schema.json tells editors the same.
struct ConfigField {
    std::string path;  ///< JSON pointer, in which * stands for each item of a list.
    std::string type;  ///< As JSON Schema names it: number, integer, boolean, string or array.
    double low = 0.0;  ///< Least number, or least count of an array's items.
    double high = 0.0;
    std::vector<std::string> choices;  ///< Of a string that is not free.
    std::string default_value;         ///< JSON text; empty for a key that may be absent.
    std::string unit;                  ///< Empty where there is none.
    std::string description;
};

/// Every key that parse_config() knows.
std::vector<ConfigField> config_fields();
/// The same with a config's own values in place of the defaults.
std::vector<ConfigField> config_values(const Config& config);

/// Parses the text; `file` names it in messages. Comments are allowed; keys that are not there
/// keep their defaults; an unknown key is a warning that names the nearest known one. A failure's
/// message has a line for each error, at most 20.
[[nodiscard]] Result<LoadedConfig> parse_config(std::string_view text, std::string_view file);

/// Reads and parses a file of at most 1 MiB.
[[nodiscard]] Result<LoadedConfig> load_config(const std::filesystem::path& path);

}  // namespace hyrax
