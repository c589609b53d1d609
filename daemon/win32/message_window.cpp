// SPDX-License-Identifier: MIT
#include "daemon/win32/message_window.h"

#include "daemon/win32/text.h"

#include <spdlog/spdlog.h>

#include <exception>

namespace hyrax::win32 {

namespace {

MessageHandler* handler_of(HWND window, UINT message, LPARAM lparam) {
    if (message == WM_NCCREATE) {
        const auto* creation = reinterpret_cast<const CREATESTRUCTW*>(lparam);
        ::SetWindowLongPtrW(
            window, GWLP_USERDATA, reinterpret_cast<LONG_PTR>(creation->lpCreateParams)
        );
    }
    return reinterpret_cast<MessageHandler*>(::GetWindowLongPtrW(window, GWLP_USERDATA));
}

/// The system calls this through frames that exceptions cannot cross.
LRESULT CALLBACK
window_procedure(HWND window, UINT message, WPARAM wparam, LPARAM lparam) noexcept {
    try {
        if (MessageHandler* const handler = handler_of(window, message, lparam)) {
            if (const auto answer = handler->on_message(window, message, wparam, lparam)) {
                return *answer;
            }
        }
    } catch (const std::exception& problem) {
        spdlog::error("window message {:#x}: {}", message, problem.what());
    }
    return ::DefWindowProcW(window, message, wparam, lparam);
}

}  // namespace

Result<Window> create_window(const WindowPlan& plan, MessageHandler& handler) {
    WNDCLASSEXW kind{};
    kind.cbSize = sizeof kind;
    kind.lpfnWndProc = window_procedure;
    kind.hInstance = ::GetModuleHandleW(nullptr);
    kind.hCursor = ::LoadCursorW(nullptr, IDC_ARROW);
    kind.lpszClassName = plan.class_name;
    if (::RegisterClassExW(&kind) == 0 && ::GetLastError() != ERROR_CLASS_ALREADY_EXISTS) {
        return std::unexpected(system_error("cannot register a window class"));
    }
    Window window(::CreateWindowExW(
        plan.extended_style,
        plan.class_name,
        plan.title.c_str(),
        plan.style,
        0,
        0,
        0,
        0,
        nullptr,
        nullptr,
        kind.hInstance,
        &handler
    ));
    if (!window) {
        return std::unexpected(system_error("cannot create a window"));
    }
    return window;
}

}  // namespace hyrax::win32
