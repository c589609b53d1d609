// SPDX-License-Identifier: MIT
// How the machine and the session are, for presence.h: power, display, lock, animations.
#pragma once

#include "daemon/core/facts.h"
#include "daemon/win32/handle.h"
#include "daemon/win32/system_library.h"
#include "physics/ticks.h"

#include <wtsapi32.h>

namespace hyrax::win32 {

using PowerNotification = Handle<HPOWERNOTIFY, ::UnregisterPowerSettingNotification>;

class MachineWatch {
public:
    /// `window`, a top-level one, gets the messages for take(). What cannot be registered is
    /// logged and does without.
    MachineWatch(HWND window, Ticks now, Facts& facts);
    MachineWatch(const MachineWatch&) = delete;
    MachineWatch& operator=(const MachineWatch&) = delete;
    ~MachineWatch();

    /// Reads a message of the window into the facts; other messages mean nothing to it.
    static void take(UINT message, WPARAM wparam, LPARAM lparam, Facts& facts);

    /// When to call retry(): just after logon the session service may not be up.
    Ticks due() const { return retry_at_; }
    void retry(Ticks now);

private:
    bool hear_of_session();

    HWND window_;
    SystemLibrary sessions_{L"wtsapi32.dll"};
    PowerNotification display_;
    PowerNotification saver_;
    bool hears_of_session_ = false;
    Ticks give_up_at_;
    Ticks retry_at_ = never;
};

/// Tells the system that the process needs no speed (EcoQoS), or lets it decide again. Older
/// systems ignore it.
void ask_for_little_power(bool little);

}  // namespace hyrax::win32
