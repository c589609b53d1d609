// SPDX-License-Identifier: MIT
// What the tray, the command line and a second start may ask of the daemon.
#pragma once

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
    request::SetPaused,
    request::TogglePause,
    request::Reload,
    request::Quit>;

}  // namespace hyrax
