// SPDX-License-Identifier: MIT
// A window of another program, as the probes show it.
#pragma once

#include <windows.h>

#include <cstdio>

namespace hyrax::probe {

/// Ends the program with the window; all else is the system's.
inline LRESULT CALLBACK end_with_window(HWND window, UINT message, WPARAM wparam, LPARAM lparam) {
    if (message == WM_DESTROY) {
        ::PostQuitMessage(0);
        return 0;
    }
    return ::DefWindowProcW(window, message, wparam, lparam);
}

struct WindowPlan {
    const wchar_t* name = L"";  ///< Of its class, and its title.
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    int brush = WHITE_BRUSH;
    DWORD extended_style = 0;
    HWND owner = nullptr;
    WNDPROC handle = end_with_window;
};

/// Shows a frameless window; null when it cannot be made.
inline HWND show_window(const WindowPlan& plan) {
    WNDCLASSW type{};
    type.lpfnWndProc = plan.handle;
    type.hInstance = ::GetModuleHandleW(nullptr);
    type.lpszClassName = plan.name;
    type.hbrBackground = static_cast<HBRUSH>(::GetStockObject(plan.brush));
    type.hCursor = ::LoadCursorW(nullptr, reinterpret_cast<LPCWSTR>(IDC_ARROW));
    ::RegisterClassW(&type);
    const HWND window = ::CreateWindowExW(
        plan.extended_style,
        plan.name,
        plan.name,
        WS_POPUP | WS_VISIBLE,
        plan.x,
        plan.y,
        plan.width,
        plan.height,
        plan.owner,
        nullptr,
        type.hInstance,
        nullptr
    );
    if (window != nullptr) {
        ::UpdateWindow(window);
    }
    return window;
}

/// Prints a line for the harness, which reads while the program runs.
inline void tell(const char* line) {
    std::puts(line);
    std::fflush(stdout);
}

/// Until the window has gone.
inline int run() {
    MSG message{};
    while (::GetMessageW(&message, nullptr, 0, 0) > 0) {
        ::DispatchMessageW(&message);
    }
    return 0;
}

}  // namespace hyrax::probe
