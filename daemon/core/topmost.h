// SPDX-License-Identifier: MIT
// Decides when the panes have to be put on top once more. Pure.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/core/frame.h"
#include "physics/ticks.h"

#include <cstdint>
#include <deque>
#include <span>

namespace hyrax {

/// Where the pets stand among all windows.
enum class Layer : std::uint8_t {
    above_taskbar,  ///< Above all, and again when the taskbar has gone above them.
    top,            ///< Above all but what goes above them later, such as the taskbar.
    bottom,         ///< Below all, on the wallpaper.
};

/// A part of a sprite lies on a monitor's taskbar, which may go above it at any time.
bool reaches_taskbars(const Frame& frame, std::span<const Monitor> monitors);

/// All topmost windows are in one order, and whoever comes last is above: the taskbar raises
/// itself without telling, after the event of what has made it do so. Another program may want to
/// be the topmost one, too; that fight is given up.
class TopmostKeeper {
public:
    /// Another window has come to the front: a check now and one in 250 ms.
    void hint(Ticks now);
    /// Whether panes could be covered just now: a check each second.
    void set_exposed(bool exposed, Ticks now);
    Ticks due() const;

    struct Sight {
        bool buried = false;           ///< Panes are not where they should be.
        bool flyout_in_front = false;  ///< A menu or the Start menu: nothing may go above it.
    };
    /// A check that was due. True: raise the panes now.
    bool check(Sight sight, Ticks now);

private:
    Ticks hinted_at_ = never;  ///< Of the next check after a hint.
    bool retried_ = true;
    Ticks exposed_at_ = never;  ///< Of the next check while exposed.
    Ticks raised_at_ = never;   ///< When panes were last raised, if that was not in vain so far.
    std::deque<Ticks> lost_;    ///< When raising turned out to have been in vain.
    Ticks truce_until_ = 0;
};

}  // namespace hyrax
