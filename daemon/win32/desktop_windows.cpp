// SPDX-License-Identifier: MIT
#include "daemon/win32/desktop_windows.h"

#include "daemon/win32/rect_from.h"

#include <exception>

namespace hyrax::win32 {
namespace {

// DWMWA_EXTENDED_FRAME_BOUNDS and DWMWA_CLOAKED: dwmapi.h comes with a library to link.
constexpr DWORD visible_frame = 9;
constexpr DWORD cloaked = 14;

struct Reading {
    const DesktopWindows* reader;
    std::vector<DesktopWindow>* windows;
};

bool is_ours(HWND window) {
    DWORD process = 0;
    ::GetWindowThreadProcessId(window, &process);
    return process == ::GetCurrentProcessId();
}

/// Without a caption, what a hidden window owns is not what people take for a window.
bool has_shown_owner(HWND window) {
    return ::IsWindowVisible(::GetAncestor(window, GA_ROOTOWNER)) != 0;
}

}  // namespace

std::vector<DesktopWindow> DesktopWindows::read() {
    if (!loaded_) {
        loaded_ = true;
        library_ = Library(::LoadLibraryExW(L"dwmapi.dll", nullptr, LOAD_LIBRARY_SEARCH_SYSTEM32));
        if (library_) {
            attribute_ = reinterpret_cast<Attribute>(
                reinterpret_cast<void*>(::GetProcAddress(library_.raw(), "DwmGetWindowAttribute"))
            );
        }
    }
    std::vector<DesktopWindow> windows;
    Reading reading{this, &windows};
    ::EnumWindows(add_window, reinterpret_cast<LPARAM>(&reading));
    return windows;
}

/// EnumWindows goes from the topmost window down.
BOOL CALLBACK DesktopWindows::add_window(HWND window, LPARAM parameter) noexcept {
    const auto& reading = *reinterpret_cast<const Reading*>(parameter);
    if (::IsWindowVisible(window) == 0 || ::IsIconic(window) != 0 || is_ours(window) ||
        reading.reader->is_cloaked(window)) {
        return TRUE;
    }
    const auto style = static_cast<DWORD>(::GetWindowLongW(window, GWL_STYLE));
    const auto more = static_cast<DWORD>(::GetWindowLongW(window, GWL_EXSTYLE));
    const RECT frame = reading.reader->frame_of(window);
    try {
        reading.windows->push_back({
            .id = id_of(window),
            .bounds = rect_from(frame),
            .active = window == ::GetForegroundWindow(),
            .visible = true,
            .solid = (more & WS_EX_TRANSPARENT) == 0,
            .has_caption = (style & WS_CAPTION) == WS_CAPTION ||
                           ((more & WS_EX_TOOLWINDOW) == 0 && has_shown_owner(window)),
            .maximised = ::IsZoomed(window) != 0,
        });
    } catch (const std::exception&) {
        return FALSE;
    }
    return TRUE;
}

// By the system: on another virtual desktop, or an app that sleeps.
bool DesktopWindows::is_cloaked(HWND window) const {
    DWORD how = 0;
    return attribute_ != nullptr && SUCCEEDED(attribute_(window, cloaked, &how, sizeof how)) &&
           how != 0;
}

// Without the shadow, which GetWindowRect counts in.
RECT DesktopWindows::frame_of(HWND window) const {
    RECT frame{};
    const bool known = attribute_ != nullptr &&
                       SUCCEEDED(attribute_(window, visible_frame, &frame, sizeof frame)) &&
                       frame.right > frame.left;
    if (!known) {
        ::GetWindowRect(window, &frame);
    }
    return frame;
}

}  // namespace hyrax::win32
