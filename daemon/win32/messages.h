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

inline constexpr UINT_PTR modal_timer = 1;

}  // namespace hyrax::win32
