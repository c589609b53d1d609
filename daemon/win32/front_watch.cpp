// SPDX-License-Identifier: MIT
#include "daemon/win32/front_watch.h"

#include "daemon/core/presence.h"
#include "daemon/win32/messages.h"
#include "daemon/win32/process.h"
#include "daemon/win32/rect_from.h"
#include "daemon/win32/single_instance.h"
#include "daemon/win32/text.h"

#include <shellapi.h>
#include <tlhelp32.h>

#include <algorithm>
#include <array>
#include <cwchar>
#include <string_view>
#include <utility>

namespace hyrax::win32 {

namespace {

constexpr std::size_t most_remembered = 16;

constexpr std::array<std::string_view, 8> flyout_classes{
    "#32768",  // menus
    "Windows.UI.Core.CoreWindow",
    "XamlExplorerHostIslandWindow",
    "NotifyIconOverflowWindow",
    "TopLevelWindowForOverflowXamlIsland",
    "ControlCenterWindow",
    "Shell_InputSwitchTopLevelWindow",
    "TaskListThumbnailWnd",
};

std::string class_of(HWND window) {
    wchar_t name[257] = L"";
    const int length = ::GetClassNameW(window, name, static_cast<int>(std::size(name)));
    return utf8({name, static_cast<std::size_t>(std::max(0, length))});
}

bool is_ours(HWND window) {
    DWORD process = 0;
    ::GetWindowThreadProcessId(window, &process);
    return process == ::GetCurrentProcessId();
}

BOOL CALLBACK post_if_daemon(HWND window, LPARAM) noexcept {
    wchar_t name[64] = L"";
    ::GetClassNameW(window, name, static_cast<int>(std::size(name)));
    if (std::wcscmp(name, daemon_window_class) != 0) {
        return TRUE;
    }
    ::PostMessageW(window, front_message, 0, 0);
    return FALSE;
}

/// Called on the thread that set the hook, which has one window of the daemon's class: there is no
/// other way to hand anything to a hook.
void CALLBACK on_front_event(HWINEVENTHOOK, DWORD, HWND, LONG, LONG, DWORD, DWORD) noexcept {
    ::EnumThreadWindows(::GetCurrentThreadId(), post_if_daemon, 0);
}

/// From the list of processes. No process is opened: guards of games take that for an attack.
std::string program_of_process(DWORD process) {
    const KernelObject list = owned_file(::CreateToolhelp32Snapshot(TH32CS_SNAPPROCESS, 0));
    PROCESSENTRY32W entry{};
    entry.dwSize = sizeof entry;
    for (BOOL more = list ? ::Process32FirstW(list.raw(), &entry) : FALSE; more != 0;
         more = ::Process32NextW(list.raw(), &entry)) {
        if (entry.th32ProcessID == process) {
            return utf8(entry.szExeFile);
        }
    }
    return {};
}

ShellState shell_state() {
    QUERY_USER_NOTIFICATION_STATE state{};
    if (FAILED(::SHQueryUserNotificationState(&state))) {
        return ShellState::ordinary;
    }
    switch (state) {
        case QUNS_RUNNING_D3D_FULL_SCREEN:
            return ShellState::exclusive;
        case QUNS_PRESENTATION_MODE:
            return ShellState::presenting;
        case QUNS_BUSY:
            return ShellState::busy;
        default:
            return ShellState::ordinary;
    }
}

}  // namespace

FrontWatch::FrontWatch(HWND daemon)
    : daemon_(daemon),
      wine_(runs_under_wine()),
      window_attribute_(dwm_.function<decltype(::DwmGetWindowAttribute)>("DwmGetWindowAttribute")) {
}

FrontWatch::~FrontWatch() {
    hear_of_full_screens(false);
}

void FrontWatch::set(Watch watch, bool name_programs, Ticks now) {
    name_programs_ = name_programs;
    if (watch == Watch::off) {
        watch_ = watch;
        hook_.reset();
        hear_of_full_screens(false);
        schedule_.stop();
        return;
    }
    if (watch_ == Watch::off) {
        hook_ = WinEventHook(::SetWinEventHook(
            EVENT_SYSTEM_FOREGROUND,
            EVENT_SYSTEM_FOREGROUND,
            nullptr,
            on_front_event,
            0,
            0,
            WINEVENT_OUTOFCONTEXT | WINEVENT_SKIPOWNPROCESS
        ));
        hear_of_full_screens(true);
        schedule_.hint(now);
    }
    watch_ = watch;
    // Wine 8 raises no EVENT_SYSTEM_FOREGROUND: a new front window is seen by looking alone.
    const Ticks period = wine_ ? 150 * ticks_per_ms : 2 * ticks_per_second;
    schedule_.set_period(watch == Watch::closely ? period : never, now);
}

void FrontWatch::hint(Ticks now) {
    if (watch_ != Watch::off) {
        schedule_.hint(now);
    }
}

/// The shell tells its appbars when a window goes full screen or back, also when that window has
/// been in front before. An appbar that never asks for a place takes none.
void FrontWatch::hear_of_full_screens(bool wanted) {
    if (wanted == is_appbar_) {
        return;
    }
    APPBARDATA data{};
    data.cbSize = sizeof data;
    data.hWnd = daemon_;
    data.uCallbackMessage = appbar_message;
    const UINT_PTR done = ::SHAppBarMessage(wanted ? ABM_NEW : ABM_REMOVE, &data);
    is_appbar_ = wanted && done != 0;
}

void FrontWatch::look(std::span<const Monitor> monitors, Ticks now, Facts& facts) {
    schedule_.looked(now);
    facts.windows.clear();
    facts.first_is_front = false;
    facts.shell = shell_state();

    HWND front = ::GetForegroundWindow();
    front = front != nullptr ? ::GetAncestor(front, GA_ROOT) : nullptr;
    if (front != nullptr && !is_ours(front)) {
        facts.windows.push_back(describe(front));
        facts.first_is_front = true;
    }
    std::erase_if(filling_, [&](HWND window) {
        if (window == front || ::IsWindow(window) == 0) {
            return true;
        }
        FrontWindow seen = describe(window);
        const bool fills_one = std::ranges::any_of(monitors, [&](const Monitor& monitor) {
            return fills(seen, monitor);
        });
        if (fills_one) {
            facts.windows.push_back(std::move(seen));
        }
        return !fills_one;
    });
    const bool fills_one =
        facts.first_is_front && std::ranges::any_of(monitors, [&](const Monitor& monitor) {
            return fills(facts.windows.front(), monitor);
        });
    if (fills_one && filling_.size() < most_remembered) {
        filling_.push_back(front);
    }
}

FrontWindow FrontWatch::describe(HWND window) {
    FrontWindow seen;
    RECT frame{};
    // Without the invisible borders, by which a maximised window reaches beyond its screen. Wine 8
    // does not know it.
    const bool known =
        window_attribute_ != nullptr &&
        SUCCEEDED(window_attribute_(window, DWMWA_EXTENDED_FRAME_BOUNDS, &frame, sizeof frame));
    if (!known) {
        ::GetWindowRect(window, &frame);
    }
    DWORD cloaked = 0;
    if (window_attribute_ != nullptr) {
        window_attribute_(window, DWMWA_CLOAKED, &cloaked, sizeof cloaked);
    }
    seen.bounds = rect_from(frame);
    seen.window_class = class_of(window);
    seen.visible = ::IsWindowVisible(window) != 0 && ::IsIconic(window) == 0;
    seen.cloaked = cloaked != 0;
    seen.captioned = (::GetWindowLongPtrW(window, GWL_STYLE) & WS_CAPTION) == WS_CAPTION;
    seen.maximised = ::IsZoomed(window) != 0;
    if (name_programs_) {
        seen.program = program_of(window);
    }
    return seen;
}

const std::string& FrontWatch::program_of(HWND window) {
    const auto known = std::ranges::find(names_, window, &Named::window);
    if (known != names_.end()) {
        return known->program;
    }
    if (names_.size() >= most_remembered) {
        names_.erase(names_.begin());
    }
    DWORD process = 0;
    ::GetWindowThreadProcessId(window, &process);
    return names_.emplace_back(window, program_of_process(process)).program;
}

bool FrontWatch::flyout_in_front() const {
    GUITHREADINFO thread{};
    thread.cbSize = sizeof thread;
    constexpr DWORD in_menu = GUI_INMENUMODE | GUI_POPUPMENUMODE | GUI_SYSTEMMENUMODE;
    if (::GetGUIThreadInfo(0, &thread) != 0 && (thread.flags & in_menu) != 0) {
        return true;
    }
    const HWND front = ::GetForegroundWindow();
    return front != nullptr &&
           std::ranges::find(flyout_classes, class_of(front)) != flyout_classes.end();
}

}  // namespace hyrax::win32
