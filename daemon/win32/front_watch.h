// SPDX-License-Identifier: MIT
// Who is in front, for presence.h: told by the system's events, and looked at where those are not
// enough.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/core/desktop.h"
#include "daemon/core/facts.h"
#include "daemon/win32/handle.h"
#include "daemon/win32/look_schedule.h"
#include "daemon/win32/system_library.h"

#include <dwmapi.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hyrax::win32 {

using WinEventHook = Handle<HWINEVENTHOOK, ::UnhookWinEvent>;

class FrontWatch {
public:
    /// `daemon`, a window of `daemon_window_class` on this thread, gets front_message and
    /// appbar_message; each means hint().
    explicit FrontWatch(HWND daemon);
    FrontWatch(const FrontWatch&) = delete;
    FrontWatch& operator=(const FrontWatch&) = delete;
    ~FrontWatch();

    void set(Watch watch, bool name_programs, Ticks now);
    void hint(Ticks now);
    /// When to call look(); `never` while off.
    Ticks due() const { return schedule_.due(); }
    /// Writes what is seen into windows, first_is_front and shell.
    void look(std::span<const Monitor> monitors, Ticks now, Facts& facts);

    /// A menu, a flyout or the Start menu is open: nothing may go above it.
    bool flyout_in_front() const;

private:
    struct Named {
        HWND window = nullptr;
        std::string program;
    };

    FrontWindow describe(HWND window);
    const std::string& program_of(HWND window);
    void hear_of_full_screens(bool wanted);

    HWND daemon_;
    Watch watch_ = Watch::off;
    bool name_programs_ = false;
    bool wine_;
    LookSchedule schedule_;
    WinEventHook hook_;
    bool is_appbar_ = false;
    std::vector<HWND> filling_;  ///< Have filled a screen when they were in front.
    std::vector<Named> names_;
    SystemLibrary dwm_{L"dwmapi.dll"};
    decltype(::DwmGetWindowAttribute)* window_attribute_;
};

}  // namespace hyrax::win32
