// SPDX-License-Identifier: MIT
// A window of another program for pets to stand on.
//   ledge_probe show x y width height   Shows it and waits until it is closed.
//   ledge_probe show-owned x y width height   The same for a window that a hidden one owns.
//   ledge_probe move x y                Moves it, from outside.
//   ledge_probe close                   Asks it to close.
#include "tests/end_to_end/probe_window.h"

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

constexpr const wchar_t* class_name = L"hyrax ledge probe";

int show(int x, int y, int width, int height, HWND owner = nullptr) {
    const HWND window = hyrax::probe::show_window(
        {.name = class_name, .x = x, .y = y, .width = width, .height = height, .owner = owner}
    );
    if (window == nullptr) {
        return 1;
    }
    hyrax::probe::tell("ready");
    return hyrax::probe::run();
}

HWND hidden_window() {
    return ::CreateWindowExW(
        0, L"STATIC", L"owner", WS_POPUP, 0, 0, 10, 10, nullptr, nullptr, nullptr, nullptr
    );
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
    if (verb == "show-owned" && count == 6) {
        return show(number(2), number(3), number(4), number(5), hidden_window());
    }
    if (verb == "move" && count == 4) {
        return move(number(2), number(3));
    }
    if (verb == "close" && count == 2) {
        return close();
    }
    std::fputs("usage: ledge_probe show|show-owned x y width height | move x y | close\n", stderr);
    return 2;
}
