// SPDX-License-Identifier: MIT
// From mouse messages to pointer inputs, in screen coordinates.
#pragma once

#include "daemon/core/desktop.h"
#include "daemon/win32/overlay.h"

#include <optional>
#include <vector>

namespace hyrax::win32 {

/// A press on a pet's pixel takes the mouse until that button comes up, wherever the pointer goes.
/// `capturer`, a hidden window, has the mouse meanwhile: panes come and go under a drag.
class Pointer {
public:
    Pointer(Overlay& overlay, std::vector<Input>& inbox) : overlay_(overlay), inbox_(inbox) {}

    /// Lets go of the mouse, as if another program had taken it.
    void give_up();
    std::optional<LRESULT> on_pane_message(HWND pane, HWND capturer, UINT message, WPARAM wparam);
    std::optional<LRESULT> on_capturer_message(
        HWND capturer, UINT message, WPARAM wparam, LPARAM lparam
    );

private:
    std::optional<LRESULT> press(HWND pane, HWND capturer, Button button);
    bool turn(HWND pane, WPARAM wparam);
    void move(WPARAM held_keys);
    void release(Button button);
    void lose();

    Overlay& overlay_;
    std::vector<Input>& inbox_;
    std::optional<Button> held_;
    int wheel_rest_ = 0;  ///< Of a notch that is not complete.
};

}  // namespace hyrax::win32
