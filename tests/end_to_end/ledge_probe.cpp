// SPDX-License-Identifier: MIT
// A window of another program for pets to stand on.
//   ledge_probe show x y width height   Shows it and waits until it is closed.
//   ledge_probe move x y                Moves it, from outside.
//   ledge_probe close                   Asks it to close.
#include <windows.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

constexpr const wchar_t* class_name = L"hyrax ledge probe";

LRESULT CALLBACK handle(HWND window, UINT message, WPARAM wparam, LPARAM lparam) {
    if (message == WM_DESTROY) {
        ::PostQuitMessage(0);
        return 0;
    }
    return ::DefWindowProcW(window, message, wparam, lparam);
}

int show(int x, int y, int width, int height) {
    WNDCLASSW type{};
    type.lpfnWndProc = handle;
    type.hInstance = ::GetModuleHandleW(nullptr);
    type.lpszClassName = class_name;
    type.hbrBackground = static_cast<HBRUSH>(::GetStockObject(WHITE_BRUSH));
    ::RegisterClassW(&type);
    const HWND window = ::CreateWindowExW(
        0,
        class_name,
        class_name,
        WS_POPUP | WS_VISIBLE,
        x,
        y,
        width,
        height,
        nullptr,
        nullptr,
        type.hInstance,
        nullptr
    );
    if (window == nullptr) {
        return 1;
    }
    ::UpdateWindow(window);
    std::puts("ready");
    std::fflush(stdout);  // the harness reads while the program runs

    MSG message{};
    while (::GetMessageW(&message, nullptr, 0, 0) > 0) {
        ::DispatchMessageW(&message);
    }
    return 0;
}

int move(int x, int y) {
    const HWND window = ::FindWindowW(class_name, nullptr);
    const UINT flags = SWP_NOSIZE | SWP_NOZORDER | SWP_NOACTIVATE;
    return window != nullptr && ::SetWindowPos(window, nullptr, x, y, 0, 0, flags) != 0 ? 0 : 1;
}

int close() {
    const HWND window = ::FindWindowW(class_name, nullptr);
    return window != nullptr && ::PostMessageW(window, WM_CLOSE, 0, 0) != 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
    const std::string_view verb = count > 1 ? words[1] : "";
    const auto number = [words](int index) { return std::atoi(words[index]); };
    if (verb == "show" && count == 6) {
        return show(number(2), number(3), number(4), number(5));
    }
    if (verb == "move" && count == 4) {
        return move(number(2), number(3));
    }
    if (verb == "close" && count == 2) {
        return close();
    }
    std::fputs("usage: ledge_probe show x y width height | move x y | close\n", stderr);
    return 2;
}
