// SPDX-License-Identifier: MIT
// The menu of the tray icon.
#pragma once

#include "daemon/core/desktop.h"

#include <windows.h>

namespace hyrax::win32 {

enum class MenuCommand : UINT {
    none,
    spawn,
    fling_all,
    reset_all,
    pause,
    open_config,
    reload,
    about,
    quit,
};

/// Shows the menu and waits for a choice, in a message loop of the system's own. `owner` is the
/// window of the tray icon; the anchor is in virtual desktop pixels.
MenuCommand choose_from_menu(HWND owner, Point anchor, const Status& status);

}  // namespace hyrax::win32
