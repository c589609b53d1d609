// SPDX-License-Identifier: MIT
// Menus: when they open, who has the focus afterwards, what the desktop's own items do. And what
// else the shell does for the daemon: notices and hotkeys.
#include "daemon/win32/messages.h"
#include "daemon/win32/process.h"
#include "daemon/win32/text.h"
#include "daemon/win32/tray_menu.h"
#include "daemon/win32/win32_desktop.h"

#include <spdlog/spdlog.h>

#include <thread>
#include <utility>

namespace hyrax::win32 {

namespace {

/// On a thread of its own, which nobody waits for: the shell may take seconds.
void open_aside(Result<void> (*open)(const std::filesystem::path&), std::filesystem::path path) {
    std::thread([open, path = std::move(path)] {
        if (const Result<void> opened = open(path); !opened) {
            spdlog::error("{}", opened.error().message);
        }
    }).detach();
}

}  // namespace

/// One at a time: Enter on the icon asks for it twice.
void Win32Desktop::ask_for_menu(Point anchor) {
    if (!menu_open_ && !tray_menu_wanted_) {
        tray_menu_wanted_ = true;
        inbox_.emplace_back(input::MenuWanted{anchor, autostart_.is_on()});
    }
}

/// By a message: the system's loop of an open menu must run inside wait(), not inside the daemon.
void Win32Desktop::show_menu(MenuItems menu, Point anchor) {
    const bool of_tray = std::exchange(tray_menu_wanted_, false);
    if (!menu_open_) {
        offered_menu_ = {std::move(menu), anchor, of_tray};
        ::PostMessageW(daemon_.raw(), menu_message, 0, 0);
    }
}

void Win32Desktop::open_menu() {
    if (menu_open_ || !offered_menu_) {
        return;
    }
    const OfferedMenu menu = *std::exchange(offered_menu_, std::nullopt);
    const HWND former = ::GetForegroundWindow();
    menu_open_ = true;
    begin_modal();
    MenuAction chosen = choose_from_menu(daemon_.raw(), menu.anchor, menu.items);
    end_modal();
    menu_open_ = false;
    if (std::holds_alternative<std::monostate>(chosen) || !menu.of_tray) {
        give_back_focus(former, menu.of_tray);
    }
    carry_out(std::move(chosen));
}

/// To the notification area, or to whom a pet's menu has taken it from. Not if the user has gone
/// elsewhere meanwhile.
void Win32Desktop::give_back_focus(HWND former, bool of_tray) {
    if (::GetForegroundWindow() != daemon_.raw()) {
        return;
    }
    if (of_tray) {
        tray_->take_focus();
    } else if (::IsWindow(former) != 0) {
        ::SetForegroundWindow(former);
    }
}

void Win32Desktop::carry_out(MenuAction action) {
    if (auto* const request = std::get_if<Request>(&action)) {
        ask(std::move(*request));
    } else if (const auto* const command = std::get_if<DesktopCommand>(&action)) {
        std::visit([this](const auto& which) { carry_out(which); }, *command);
    }
}

void Win32Desktop::carry_out(const desktop_command::OpenConfig&) {
    open_aside(open_in_editor, options_.config_file);
}

void Win32Desktop::carry_out(const desktop_command::OpenScripts&) {
    open_aside(open_folder, options_.scripts_folder);
}

void Win32Desktop::carry_out(const desktop_command::OpenLog&) {
    open_aside(open_in_editor, options_.log_file);
}

void Win32Desktop::carry_out(const desktop_command::ShowAbout&) {
    about_->open();
}

void Win32Desktop::carry_out(const desktop_command::SetAutostart& autostart) {
    if (const Result<void> done = autostart_.set(autostart.on); !done) {
        spdlog::error("{}", done.error().message);
    }
    autostart_.offer_restart(options_.restart_arguments);
}

void Win32Desktop::greet(const std::string& text) {
    tray_->notify(L"hyrax", wide(text));
}

void Win32Desktop::notify(const std::string& title, const std::string& text) {
    tray_->notify(wide(title), wide(text));
}

Result<void> Win32Desktop::take_hotkey(HotkeyId id, const KeyCombination& keys) {
    return hotkeys_->take(id, keys);
}

void Win32Desktop::give_back_hotkey(HotkeyId id) {
    hotkeys_->give_back(id);
}

WallTime Win32Desktop::wall_time() {
    return wall_clock();
}

}  // namespace hyrax::win32
