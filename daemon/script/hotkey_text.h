// SPDX-License-Identifier: MIT
// How scripts spell hotkeys.
#pragma once

#include "daemon/core/result.h"

#include <string>
#include <string_view>

namespace hyrax::script {

/// "Alt + CTRL+h" becomes "ctrl+alt+h": modifiers in a fixed order (ctrl, alt, shift, win), then
/// one key: a letter, a digit, f1 to f24, space, tab, enter, escape, insert, delete, home, end,
/// pageup, pagedown, left, right, up or down. A key other than f1 to f24 needs ctrl, alt or win.
[[nodiscard]] Result<std::string> normal_hotkey(std::string_view text);

}  // namespace hyrax::script
