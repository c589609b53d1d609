// SPDX-License-Identifier: MIT
#include "daemon/win32/tray_menu.h"

#include "daemon/win32/handle.h"
#include "daemon/win32/text.h"

#include <utility>

namespace hyrax::win32 {

namespace {

/// A longer line would make the menu wider than a small screen.
constexpr std::size_t longest_problem = 90;

void add(HMENU menu, MenuCommand command, const wchar_t* text, UINT flags = 0) {
    ::AppendMenuW(menu, MF_STRING | flags, std::to_underlying(command), text);
}

void add_line(HMENU menu) {
    ::AppendMenuW(menu, MF_SEPARATOR, 0, nullptr);
}

std::wstring menu_text(const std::string& text) {
    const std::wstring whole = wide(text);
    std::wstring result;
    for (const wchar_t unit : shortened(whole, longest_problem)) {
        result += unit;
        if (unit == L'&') {
            result += unit;  // A single one would underline the next letter.
        }
    }
    return result;
}

Menu build(const Status& status) {
    Menu menu(::CreatePopupMenu());
    if (!status.problem.empty()) {
        add(menu.raw(), MenuCommand::none, menu_text(status.problem).c_str(), MF_GRAYED);
        add_line(menu.raw());
    }
    add(menu.raw(), MenuCommand::spawn, L"&Spawn hyrax");
    add(menu.raw(), MenuCommand::fling_all, L"&Fling all");
    add(menu.raw(), MenuCommand::reset_all, L"&Reset all");
    add(menu.raw(), MenuCommand::pause, L"&Pause", status.paused ? MF_CHECKED : 0U);
    add_line(menu.raw());
    add(menu.raw(), MenuCommand::open_config, L"Open &config");
    add(menu.raw(), MenuCommand::reload, L"Re&load");
    add_line(menu.raw());
    add(menu.raw(), MenuCommand::about, L"&About hyrax");
    add(menu.raw(), MenuCommand::quit, L"&Quit");
    return menu;
}

}  // namespace

MenuCommand choose_from_menu(HWND owner, Point anchor, const Status& status) {
    const Menu menu = build(status);
    // Without the first call, a click elsewhere does not close the menu; without the message at
    // the end, the next menu closes at once (remarks on TrackPopupMenu).
    ::SetForegroundWindow(owner);
    const UINT side =
        ::GetSystemMetrics(SM_MENUDROPALIGNMENT) != 0 ? TPM_RIGHTALIGN : TPM_LEFTALIGN;
    const BOOL chosen = ::TrackPopupMenuEx(
        menu.raw(),
        TPM_RETURNCMD | TPM_RIGHTBUTTON | TPM_NONOTIFY | side,
        anchor.x,
        anchor.y,
        owner,
        nullptr
    );
    ::PostMessageW(owner, WM_NULL, 0, 0);
    return static_cast<MenuCommand>(chosen);
}

}  // namespace hyrax::win32
