// SPDX-License-Identifier: MIT
// The icon in the notification area: comes with the program, comes back with Explorer.
#pragma once

#include "daemon/core/desktop.h"
#include "daemon/win32/handle.h"
#include "physics/ticks.h"

#include <shellapi.h>

#include <functional>
#include <string>

namespace hyrax::win32 {

/// Does what ::Shell_NotifyIconW does; a test brings its own.
using ShellNotify = std::function<bool(DWORD action, NOTIFYICONDATAW& data)>;
bool shell_notify(DWORD action, NOTIFYICONDATAW& data);

/// The icon's text: a constant first line, by which Windows 11 remembers where the user put the
/// icon, then the state and the problem, as far as they fit.
std::wstring tip_text(const Status& status);

class TrayIcon {
public:
    /// `owner` gets `message` from the icon.
    TrayIcon(HWND owner, UINT message, ShellNotify shell, Ticks now);
    TrayIcon(const TrayIcon&) = delete;
    TrayIcon& operator=(const TrayIcon&) = delete;
    ~TrayIcon();

    void set_tip(const std::wstring& tip);
    /// For a change of the DPI or of the taskbar, and after Explorer has restarted.
    void renew(Ticks now);
    /// A balloon with a title and a line of text, cut where they are too long, unless the user
    /// wants no such now.
    void notify(const std::wstring& title, const std::wstring& text);
    /// Gives the keyboard back to the notification area after a menu was closed.
    void take_focus();

    /// When to call retry(): no taskbar has been there so far.
    Ticks due() const { return retry_at_; }
    void retry(Ticks now);
    bool shown() const { return shown_; }

private:
    NOTIFYICONDATAW data() const;
    void load_icon();
    void put(Ticks now);

    HWND owner_;
    UINT message_;
    ShellNotify shell_;
    Icon icon_;
    std::wstring tip_ = L"hyrax";
    bool shown_ = false;
    std::size_t failed_attempts_ = 0;
    Ticks retry_at_ = never;
};

}  // namespace hyrax::win32
