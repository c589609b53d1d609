// SPDX-License-Identifier: MIT
// Hears of changes of other programs' windows while somebody wants to know of them.
#pragma once

#include "daemon/core/desktop.h"
#include "daemon/win32/debounce.h"
#include "daemon/win32/desktop_windows.h"
#include "daemon/win32/handle.h"
#include "physics/ticks.h"

#include <cstdint>
#include <vector>

namespace hyrax::win32 {

/// Out-of-context hooks: nothing of ours runs in other programs. Narrow ranges of events, for each
/// event costs its sender; moves are heard from the threads alone whose windows carry a pet or are
/// being dragged, for the mouse cursor is a window that moves. One to a thread, whose messages must
/// be dispatched.
class WindowWatch {
public:
    WindowWatch();
    WindowWatch(const WindowWatch&) = delete;
    WindowWatch& operator=(const WindowWatch&) = delete;
    ~WindowWatch();

    /// Without any interest nothing is hooked.
    void watch(const WindowInterest& interest, Ticks now);
    /// When to call check(); `never` while nothing happens.
    Ticks due() const;
    /// True when the windows have changed, or may have.
    bool check(Ticks now);
    /// What the daemon sees from now on.
    std::vector<DesktopWindow> read();

private:
    using Hook = Handle<HWINEVENTHOOK, ::UnhookWinEvent>;

    static void CALLBACK on_event(
        HWINEVENTHOOK hook,
        DWORD event,
        HWND window,
        LONG object,
        LONG child,
        DWORD thread,
        DWORD time
    );
    void hear(DWORD event, HWND window);
    void hook_all();
    void hook_moves();

    WindowInterest interest_;
    std::vector<Hook> hooks_;
    std::vector<Hook> move_hooks_;
    std::vector<DWORD> moving_threads_;  // Those that move_hooks_ listen to, sorted.
    HWND dragged_ = nullptr;             // The window that the user moves or sizes.
    DesktopWindows reader_;
    std::vector<DesktopWindow> last_read_;
    Debounce hints_;
    Ticks poll_at_ = never;
};

}  // namespace hyrax::win32
