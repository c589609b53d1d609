// SPDX-License-Identifier: MIT
// Hotkeys that the system keeps for a window of ours.
#pragma once

#include "daemon/core/desktop.h"
#include "daemon/core/key_combination.h"
#include "daemon/core/result.h"

#include <windows.h>

#include <set>

namespace hyrax::win32 {

/// As RegisterHotKey wants it: VK_...
UINT virtual_key(Key key);

class Hotkeys {
public:
    /// `owner` gets WM_HOTKEY, with the number as wparam; not again while the keys are held.
    explicit Hotkeys(HWND owner) : owner_(owner) {}
    Hotkeys(const Hotkeys&) = delete;
    Hotkeys& operator=(const Hotkeys&) = delete;
    ~Hotkeys();

    [[nodiscard]] Result<void> take(HotkeyId id, const KeyCombination& keys);
    void give_back(HotkeyId id);

private:
    HWND owner_;
    std::set<HotkeyId> taken_;
};

}  // namespace hyrax::win32
