// SPDX-License-Identifier: MIT
// What the tray, the command line and a second start may ask of the daemon.
#pragma once

#include "daemon/core/pet.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace hyrax {

namespace request {
struct Spawn {
    std::string kind = "hyrax";
    int count = 1;
};
struct FlingAll {};
struct ResetAll {};
struct RemoveAll {};
/// Brings every pet to the monitor under the pointer, else to the primary one. Shows them first.
struct Gather {};
/// No picture, and the pets' time stands still.
struct Hide {
    std::optional<std::int64_t> seconds{};  ///< None: until Show.
};
struct Show {};
/// Pets settle and stay; scripts may not move them nor spawn any. The user's hand may.
struct SetQuiet {
    bool quiet = false;
};
/// The mouse reaches what lies below the pets.
struct SetClickThrough {
    bool on = false;
};
/// Whether pets may be on a monitor, named by its identity().
struct SetMonitor {
    std::string monitor;
    bool allowed = true;
};
/// Whether a script that the config names runs.
struct SetScript {
    std::string script;
    bool on = true;
};
/// Whether a plugin runs.
struct SetPlugin {
    std::string plugin;
    bool on = true;
};
/// Grants a plugin what it asks for and turns it on, or takes all of it back and turns it off.
struct AllowPlugin {
    std::string plugin;
    bool allowed = true;
};
struct StopPet {
    PetId pet;
};
struct ResetPet {
    PetId pet;
};
struct SetScale {
    PetId pet;
    double scale = 1.0;
};
struct RemovePet {
    PetId pet;
};
/// Every pet but this one.
struct RemoveOthers {
    PetId pet;
};
struct SetPaused {
    bool paused = false;
};
struct TogglePause {};
/// Reads config, sprite sets and scripts again.
struct Reload {};
struct Quit {};
}  // namespace request

using Request = std::variant<
    request::Spawn,
    request::FlingAll,
    request::ResetAll,
    request::RemoveAll,
    request::Gather,
    request::Hide,
    request::Show,
    request::SetQuiet,
    request::SetClickThrough,
    request::SetMonitor,
    request::SetScript,
    request::SetPlugin,
    request::AllowPlugin,
    request::StopPet,
    request::ResetPet,
    request::SetScale,
    request::RemovePet,
    request::RemoveOthers,
    request::SetPaused,
    request::TogglePause,
    request::Reload,
    request::Quit>;

}  // namespace hyrax
