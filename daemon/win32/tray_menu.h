// SPDX-License-Identifier: MIT
// Shows a menu that the core has made.
#pragma once

#include "daemon/core/menu.h"
#include "physics/geometry.h"

#include <windows.h>

namespace hyrax::win32 {

/// Shows the menu and waits for a choice, in a message loop of the system's own; what was chosen,
/// or nothing. `owner` becomes the foreground window meanwhile: without that, a click elsewhere
/// would not close the menu and no key would reach it. The anchor is in virtual desktop pixels.
MenuAction choose_from_menu(HWND owner, Point anchor, const MenuItems& items);

}  // namespace hyrax::win32
