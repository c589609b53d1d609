// SPDX-License-Identifier: MIT
// Our own messages and timers on the daemon's window.
#pragma once

#include <windows.h>

namespace hyrax::win32 {

inline constexpr UINT tray_message = WM_APP + 1;
/// wparam 1: the system has begun a message loop of its own; 0: it has ended.
inline constexpr UINT modal_message = WM_APP + 2;

/// The menu that show_menu() has been given is to be opened.
inline constexpr UINT menu_message = WM_APP + 3;

/// Sprite sets have been read: the message only wakes the daemon.
inline constexpr UINT sprites_message = WM_APP + 4;

/// Another program's window has come to the front.
inline constexpr UINT front_message = WM_APP + 20;
/// From the shell, to appbars.
inline constexpr UINT appbar_message = WM_APP + 21;
/// With --for-testing alone: wparam is a TestFact, lparam its value. What no other program can
/// send, or Wine never tells.
inline constexpr UINT test_fact_message = WM_APP + 22;

enum class TestFact : WPARAM {
    on_battery = 1,
    battery_saver = 2,
    remote_session = 3,
    display_off = 4,
    animations = 5,
    monitors = 6,  ///< That many of those that are there, the first ones; 0: none.
    wider = 7,     ///< The first monitor reads as wider by so many pixels.
};

inline constexpr UINT_PTR modal_timer = 1;

}  // namespace hyrax::win32
