// SPDX-License-Identifier: MIT
// Posts a message to all top-level windows of a class; fails if there is none.
//   post_message CLASS MESSAGE    Its number, or the name of a registered one.
#include <windows.h>

#include <cstdio>
#include <cwchar>

int wmain(int count, wchar_t** words) {
    if (count != 3) {
        std::fputs("usage: post_message CLASS MESSAGE\n", stderr);
        return 2;
    }
    const auto number = static_cast<UINT>(std::wcstoul(words[2], nullptr, 10));
    const UINT message = number != 0 ? number : ::RegisterWindowMessageW(words[2]);
    int posted = 0;
    HWND window = nullptr;
    while ((window = ::FindWindowExW(nullptr, window, words[1], nullptr)) != nullptr) {
        posted += ::PostMessageW(window, message, 0, 0) != 0 ? 1 : 0;
    }
    return posted > 0 ? 0 : 1;
}
