// SPDX-License-Identifier: MIT
// The hotkeys that a user may give the daemon in config.json.
#pragma once

#include "daemon/core/key_combination.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace hyrax {

/// What pressing one does. The last four turn it round.
enum class UserHotkey : std::uint8_t { gather, hide, pause, quiet, click_through };

/// Keys below /hotkeys, in the order of UserHotkey.
inline constexpr std::array<std::string_view, 5> user_hotkey_names{
    "gather", "hide", "pause", "quiet", "click_through"
};

/// In the order of UserHotkey; none: that hotkey is not taken.
using UserHotkeys = std::array<std::optional<KeyCombination>, user_hotkey_names.size()>;

}  // namespace hyrax
