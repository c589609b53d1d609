// SPDX-License-Identifier: MIT
#include "daemon/win32/pointer.h"

#include "daemon/win32/clock.h"

#include <windowsx.h>

#include <variant>

namespace hyrax::win32 {

namespace {

/// Of the message at hand, not of now. The macros keep the sign: monitors may lie left of zero.
Point message_point() {
    const LPARAM packed = static_cast<LPARAM>(::GetMessagePos());
    return {GET_X_LPARAM(packed), GET_Y_LPARAM(packed)};
}

WPARAM key_of(Button button) {
    switch (button) {
        case Button::right:
            return MK_RBUTTON;
        case Button::middle:
            return MK_MBUTTON;
        default:
            return MK_LBUTTON;
    }
}

}  // namespace

std::optional<LRESULT> Pointer::on_pane_message(
    HWND pane, HWND capturer, UINT message, WPARAM wparam
) {
    switch (message) {
        case WM_MOUSEWHEEL:
            return turn(pane, wparam) ? std::optional<LRESULT>(0) : std::nullopt;
        case WM_MOUSEACTIVATE:
            return MA_NOACTIVATE;
        case WM_DPICHANGED:
            return 0;  // The default resizes the window by the ratio of the two scales.
        case WM_LBUTTONDOWN:
            return press(pane, capturer, Button::left);
        case WM_RBUTTONDOWN:
            return press(pane, capturer, Button::right);
        case WM_MBUTTONDOWN:
            return press(pane, capturer, Button::middle);
        default:
            return std::nullopt;
    }
}

std::optional<LRESULT> Pointer::on_capturer_message(
    HWND capturer, UINT message, WPARAM wparam, LPARAM lparam
) {
    switch (message) {
        case WM_MOUSEMOVE:
            move(wparam);
            return 0;
        case WM_LBUTTONUP:
            release(Button::left);
            return 0;
        case WM_RBUTTONUP:
            release(Button::right);
            return 0;
        case WM_MBUTTONUP:
            release(Button::middle);
            return 0;
        case WM_CAPTURECHANGED:
            if (reinterpret_cast<HWND>(lparam) != capturer) {
                lose();
            }
            return 0;
        default:
            return std::nullopt;
    }
}

std::optional<LRESULT> Pointer::press(HWND pane, HWND capturer, Button button) {
    const Point at = message_point();
    // Windows itself lets clicks on clear pixels through; Wine does not for those of SendInput.
    if (!held_ && overlay_.has_pixel_at(pane, at)) {
        held_ = button;
        overlay_.hold(pane);
        ::SetCapture(capturer);
        inbox_.emplace_back(input::Pressed{at, button, clock_now()});
    }
    return 0;
}

void Pointer::give_up() {
    if (held_) {
        ::ReleaseCapture();
    }
}

/// Comes for the pane under the pointer only where Windows scrolls inactive windows.
bool Pointer::turn(HWND pane, WPARAM wparam) {
    const Point at = message_point();
    if ((GET_KEYSTATE_WPARAM(wparam) & MK_CONTROL) == 0 || !overlay_.has_pixel_at(pane, at)) {
        return false;
    }
    wheel_rest_ += GET_WHEEL_DELTA_WPARAM(wparam);
    const int steps = wheel_rest_ / WHEEL_DELTA;
    wheel_rest_ %= WHEEL_DELTA;
    if (steps != 0) {
        inbox_.emplace_back(input::Turned{at, steps});
    }
    return true;
}

void Pointer::move(WPARAM held_keys) {
    if (!held_) {
        return;
    }
    if ((held_keys & key_of(*held_)) == 0) {
        ::ReleaseCapture();  // The button came up unseen, behind a secure desktop for one.
        return;
    }
    const input::Moved moved{message_point(), clock_now()};
    // A later position replaces an earlier one that nobody has read.
    if (!inbox_.empty() && std::holds_alternative<input::Moved>(inbox_.back())) {
        inbox_.back() = moved;
    } else {
        inbox_.emplace_back(moved);
    }
}

void Pointer::release(Button button) {
    if (held_ == button) {
        held_.reset();
        overlay_.release();
        inbox_.emplace_back(input::Released{message_point(), button, clock_now()});
        ::ReleaseCapture();
    }
}

void Pointer::lose() {
    if (held_) {
        held_.reset();
        overlay_.release();
        inbox_.emplace_back(input::PointerLost{});
    }
}

}  // namespace hyrax::win32
