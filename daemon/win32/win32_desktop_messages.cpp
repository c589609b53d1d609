// SPDX-License-Identifier: MIT
// What the messages of the daemon's window and of the panes mean.
#include "daemon/win32/messages.h"
#include "daemon/win32/single_instance.h"
#include "daemon/win32/tray_message.h"
#include "daemon/win32/win32_desktop.h"

#include <utility>

namespace hyrax::win32 {

std::optional<LRESULT> Win32Desktop::on_message(
    HWND window, UINT message, WPARAM wparam, LPARAM lparam
) {
    if (closing_ || !tray_) {
        return std::nullopt;
    }
    if (window != daemon_.raw()) {
        if (message == WM_DPICHANGED) {
            screens_.hint(clock_now());  // Perhaps it has only crossed to another screen.
        }
        return pointer_.on_pane_message(window, daemon_.raw(), message, wparam);
    }
    if (message == taskbar_created_) {
        tray_->renew(clock_now());
        on_screens_hint();
        return 0;
    }
    if (message == statistics_message_ && tell_statistics_) {
        tell_statistics_();
        return 0;
    }
    notice(message, wparam, lparam);
    if (const auto answer = on_daemon_message(message, wparam, lparam)) {
        return answer;
    }
    return pointer_.on_capturer_message(window, message, wparam, lparam);
}

std::optional<LRESULT> Win32Desktop::on_daemon_message(UINT message, WPARAM wparam, LPARAM lparam) {
    switch (message) {
        case tray_message:
            if (const std::optional<Point> anchor = menu_anchor(wparam, lparam)) {
                ask_for_menu(*anchor);
            }
            return 0;
        case menu_message:
            open_menu();
            return 0;
        case modal_message:
            wparam != 0 ? begin_modal() : end_modal();
            return 0;
        case WM_TIMER:
            modal_tick();
            return 0;
        case WM_HOTKEY:
            inbox_.emplace_back(input::HotkeyPressed{static_cast<HotkeyId>(wparam)});
            return 0;
        case WM_COPYDATA:
            return on_handed_over(lparam) ? TRUE : FALSE;
        case WM_DISPLAYCHANGE:
            on_screens_hint();
            return 0;
        case WM_SETTINGCHANGE:
            if (wparam == SPI_SETWORKAREA) {
                on_screens_hint();
            }
            return 0;
        case WM_DPICHANGED:
            tray_->renew(clock_now());
            on_screens_hint();
            return 0;
        case WM_POWERBROADCAST:
            return TRUE;
        case WM_QUERYENDSESSION:
            return TRUE;
        case WM_ENDSESSION:
            if (wparam != FALSE) {
                end_session();
            }
            return 0;
        case WM_CLOSE:
            ask(request::Quit{});
            return 0;
        default:
            return std::nullopt;
    }
}

/// The message may come while the daemon is at work: then it is left at asking.
void Win32Desktop::end_session() {
    if (waiting_ && !in_modal_tick_ && end_session_) {
        end_session_();
    }
    ask(request::Quit{});
}

void Win32Desktop::ask(Request request) {
    inbox_.emplace_back(std::in_place_type<Request>, std::move(request));
}

/// A new mode may have emptied what the panes showed, even when all monitors stay as they were.
void Win32Desktop::on_screens_hint() {
    screens_.hint(clock_now());
    overlay_.forget_pixels();
    bubbles_.forget_pixels();
}

bool Win32Desktop::on_handed_over(LPARAM copy_data) {
    const auto arguments = handed_over_arguments(copy_data);
    if (!arguments || !options_.parse_arguments) {
        return false;
    }
    for (Request& request : options_.parse_arguments(*arguments)) {
        ask(std::move(request));
    }
    return true;
}

void Win32Desktop::begin_modal() {
    constexpr UINT period_ms = 15;  // The timer's own grain: a frame in each.
    if (modal_depth_++ == 0) {
        ::SetTimer(daemon_.raw(), modal_timer, period_ms, nullptr);
    }
}

void Win32Desktop::end_modal() {
    if (modal_depth_ > 0 && --modal_depth_ == 0) {
        ::KillTimer(daemon_.raw(), modal_timer);
    }
}

void Win32Desktop::modal_tick() {
    if (in_modal_tick_ || modal_depth_ == 0 || !go_on_) {
        return;
    }
    in_modal_tick_ = true;
    try {
        do_chores();
        if (!go_on_(std::exchange(inbox_, {}))) {
            ::EndMenu();
        }
    } catch (...) {
        in_modal_tick_ = false;
        throw;
    }
    in_modal_tick_ = false;
}

}  // namespace hyrax::win32
