// SPDX-License-Identifier: MIT
// What the system tells of the moment: who is in front, and how the machine and the session are.
#pragma once

#include "physics/geometry.h"

#include <string>
#include <vector>

namespace hyrax {

/// A top-level window of another program.
struct FrontWindow {
    Rect bounds;                 ///< Its visible frame, virtual desktop [px].
    std::string window_class{};  ///< As the system spells it.
    std::string program{};       ///< File name such as "game.exe"; empty unless rules ask for it.
    bool visible = true;         ///< Shown and not minimised.
    bool cloaked = false;        ///< On another virtual desktop, or hidden by the shell.
    bool captioned = false;      ///< Has a title bar, be it one that it draws itself.
    bool maximised = false;
    bool operator==(const FrontWindow&) const = default;
};

/// Whether the user may be disturbed, as the shell sees it (SHQueryUserNotificationState).
enum class ShellState {
    ordinary,
    busy,        ///< Some window is large. Means nothing: also said of an empty desktop.
    exclusive,   ///< A program has a screen to itself, below the desktop's composition.
    presenting,  ///< The user has said that a presentation is on.
};

struct Facts {
    /// The window with the keyboard first, if there is one and it is not ours; then those that
    /// were found to fill a screen before and still do.
    std::vector<FrontWindow> windows{};
    bool first_is_front = false;  ///< False: nobody has the keyboard, or we do.
    ShellState shell = ShellState::ordinary;
    bool on_battery = false;
    bool battery_saver = false;
    bool remote_session = false;
    bool locked = false;
    bool disconnected = false;  ///< The session has no screen: another user's has.
    bool display_off = false;
    bool suspended = false;
    bool animations = true;        ///< The user wants windows to animate.
    bool capture_refused = false;  ///< Pets show in captures although they were to be left out.
    bool operator==(const Facts&) const = default;
};

}  // namespace hyrax
