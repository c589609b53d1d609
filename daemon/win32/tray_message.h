// SPDX-License-Identifier: MIT
// What a message of the tray icon means (NOTIFYICON_VERSION_4). Pure.
#pragma once

#include "physics/geometry.h"

#include <cstdint>
#include <optional>

namespace hyrax::win32 {

/// Where to open the menu, if the message asks for it: by either mouse button or the keyboard.
/// [virtual desktop; the icon itself for the keyboard]
constexpr std::optional<Point> menu_anchor(std::uint64_t wparam, std::int64_t lparam) {
    constexpr unsigned context_menu = 0x007B;  // WM_CONTEXTMENU
    constexpr unsigned select = 0x0400;        // NIN_SELECT
    constexpr unsigned key_select = 0x0401;    // NIN_KEYSELECT
    const auto event = static_cast<unsigned>(lparam & 0xFFFF);
    if (event != context_menu && event != select && event != key_select) {
        return std::nullopt;
    }
    // Signed: the taskbar may lie on a monitor left of or above the primary one.
    return Point{
        static_cast<std::int16_t>(wparam & 0xFFFF),
        static_cast<std::int16_t>((wparam >> 16U) & 0xFFFF)
    };
}

}  // namespace hyrax::win32
