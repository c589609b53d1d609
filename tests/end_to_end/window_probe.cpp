// SPDX-License-Identifier: MIT
// Tells the harness what a Win32 program sees: the monitors, and the clicks that reach its window.
//   window_probe x y width height   Shows a plain window there; ends when it is closed.
#include "tests/end_to_end/probe_window.h"

#include <cstdio>
#include <cstdlib>

namespace {

BOOL CALLBACK tell_monitor(HMONITOR monitor, HDC, RECT*, LPARAM) {
    MONITORINFO info{};
    info.cbSize = sizeof info;
    ::GetMonitorInfoW(monitor, &info);
    const RECT& r = info.rcMonitor;
    const char* kind = (info.dwFlags & MONITORINFOF_PRIMARY) != 0 ? "primary" : "other";
    std::printf("monitor %ld %ld %ld %ld %s\n", r.left, r.top, r.right, r.bottom, kind);
    return TRUE;
}

void tell_button(HWND window, const char* what, LPARAM position) {
    // Signed: a client coordinate is negative while the mouse is captured.
    POINT point{static_cast<short>(LOWORD(position)), static_cast<short>(HIWORD(position))};
    ::ClientToScreen(window, &point);
    std::printf("%s %ld %ld\n", what, point.x, point.y);
    std::fflush(stdout);
}

LRESULT CALLBACK handle(HWND window, UINT message, WPARAM wparam, LPARAM lparam) {
    switch (message) {
        case WM_LBUTTONDOWN:
            tell_button(window, "down", lparam);
            return 0;
        case WM_LBUTTONUP:
            tell_button(window, "up", lparam);
            return 0;
        case WM_RBUTTONDOWN:
            tell_button(window, "right", lparam);
            return 0;
        default:
            return hyrax::probe::end_with_window(window, message, wparam, lparam);
    }
}

}  // namespace

int main(int count, char** words) {
    if (count != 5) {
        std::fputs("usage: window_probe x y width height\n", stderr);
        return 2;
    }
    ::EnumDisplayMonitors(nullptr, nullptr, tell_monitor, 0);

    const HWND window = hyrax::probe::show_window({
        .name = L"hyrax window probe",
        .x = std::atoi(words[1]),
        .y = std::atoi(words[2]),
        .width = std::atoi(words[3]),
        .height = std::atoi(words[4]),
        .extended_style = WS_EX_TOOLWINDOW,
        .handle = handle,
    });
    if (window == nullptr) {
        return 1;
    }
    hyrax::probe::tell("ready");
    return hyrax::probe::run();
}
