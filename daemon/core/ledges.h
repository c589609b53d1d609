// SPDX-License-Identifier: MIT
// Which parts of which window tops are ledges. Pure: a list of windows comes in, segments come out.
#pragma once

#include "daemon/core/arena.h"
#include "physics/free_space.h"
#include "physics/geometry.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hyrax {

/// Whose tops pets can stand on.
enum class LedgeMode : std::uint8_t {
    off,
    active,  ///< The foreground window's alone.
    all,
};

/// A window as the desktop reports it, in physical pixels of the virtual desktop.
struct DesktopWindow {
    std::uint64_t id = 0;  ///< The system's; may come again once the window is gone.
    Rect bounds;           ///< What is seen of it, without shadows.
    bool active = false;   ///< In the foreground.
    bool visible = true;   ///< Shown, not minimised, not cloaked by the system.
    bool solid = true;     ///< Catches the mouse: false for our own windows and for overlays.
    /// False for menus, bars and tips: tool windows, and what a hidden window owns, without one.
    bool has_caption = true;
    bool maximised = false;
    bool operator==(const DesktopWindow&) const = default;
};

/// A visible part of the top of a window.
struct LedgeSegment {
    Ledge ledge;
    std::uint64_t window = 0;
    Rect bounds;  ///< Of the window.
    bool operator==(const LedgeSegment&) const = default;
};

/// A smaller window is no ledge [px].
inline constexpr Size least_ledge_window{64, 32};
/// No more windows than these give ledges, the topmost first.
inline constexpr int most_ledge_windows = 64;

/// `windows`: the topmost first. A window's segments are its top edge minus the windows above it,
/// within the monitors' work areas, from the left to the right. Whatever is visible and solid
/// covers; maximised windows, and those that fill a monitor, give no ledge.
std::vector<LedgeSegment> ledges_of(
    std::span<const DesktopWindow> windows, const std::vector<Monitor>& monitors, LedgeMode mode
);

}  // namespace hyrax
