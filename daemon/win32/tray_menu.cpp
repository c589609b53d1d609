// SPDX-License-Identifier: MIT
#include "daemon/win32/tray_menu.h"

#include "daemon/win32/handle.h"
#include "daemon/win32/text.h"

#include <vector>

namespace hyrax::win32 {

namespace {

/// Fills a menu and numbers its items from 1, submenus included.
class MenuBuilder {
public:
    Menu build(const MenuItems& items) {
        Menu menu(::CreatePopupMenu());
        for (const MenuItem& item : items) {
            add(menu.raw(), item);
        }
        return menu;
    }
    MenuAction action(int number) const {
        const auto index = static_cast<std::size_t>(number) - 1;
        return number > 0 && index < numbered_.size() ? numbered_[index]->action : MenuAction{};
    }

private:
    void add(HMENU menu, const MenuItem& item) {
        if (item.is_line()) {
            ::AppendMenuW(menu, MF_SEPARATOR, 0, nullptr);
            return;
        }
        const UINT flags = MF_STRING | (item.checked ? MF_CHECKED : 0U) |
                           (item.enabled ? 0U : static_cast<UINT>(MF_GRAYED));
        const std::wstring text = wide(item.text);
        if (item.children.empty()) {
            numbered_.push_back(&item);
            ::AppendMenuW(menu, flags, numbered_.size(), text.c_str());
            return;
        }
        Menu children = build(item.children);
        const auto id = reinterpret_cast<UINT_PTR>(children.raw());
        if (::AppendMenuW(menu, flags | MF_POPUP, id, text.c_str()) != 0) {
            children.release();  // It goes with the menu that it hangs in.
        }
    }

    std::vector<const MenuItem*> numbered_;
};

}  // namespace

MenuAction choose_from_menu(HWND owner, Point anchor, const MenuItems& items) {
    MenuBuilder builder;
    const Menu menu = builder.build(items);
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
    return builder.action(chosen);
}

}  // namespace hyrax::win32
