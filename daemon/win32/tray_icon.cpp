// SPDX-License-Identifier: MIT
#include "daemon/win32/tray_icon.h"

#include "daemon/win32/resources/ids.h"
#include "daemon/win32/text.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>

namespace hyrax::win32 {

namespace {

/// No GUID instead: Windows ties one to the path of the program, and an icon of a portable copy
/// that was moved could not be added.
constexpr UINT icon_id = 1;

/// At logon the program may be earlier than the taskbar.
constexpr std::array<Ticks, 6> retry_after{
    1 * ticks_per_second,
    2 * ticks_per_second,
    4 * ticks_per_second,
    8 * ticks_per_second,
    15 * ticks_per_second,
    30 * ticks_per_second,
};

}  // namespace

bool shell_notify(DWORD action, NOTIFYICONDATAW& data) {
    return ::Shell_NotifyIconW(action, &data) != 0;
}

std::wstring tip_text(const Status& status) {
    const std::string pets =
        status.pets == 1 ? std::string("1 pet") : std::to_string(status.pets) + " pets";
    std::string text = "hyrax\n" + pets + (status.paused ? ", paused" : "") +
                       (status.hidden ? ", hidden" : "") + (status.quiet ? ", quiet" : "") +
                       (status.click_through ? ", clicks go through" : "");
    if (!status.problem.empty()) {
        text += "\n" + status.problem;
    }
    if (!status.note.empty()) {
        text += "\n" + status.note;
    }
    return std::wstring(shortened(wide(text), std::size(NOTIFYICONDATAW{}.szTip) - 1));
}

TrayIcon::TrayIcon(HWND owner, UINT message, ShellNotify shell, Ticks now)
    : owner_(owner), message_(message), shell_(std::move(shell)) {
    load_icon();
    put(now);
}

TrayIcon::~TrayIcon() {
    NOTIFYICONDATAW icon = data();
    shell_(NIM_DELETE, icon);
}

NOTIFYICONDATAW TrayIcon::data() const {
    NOTIFYICONDATAW icon{};
    icon.cbSize = sizeof icon;
    icon.hWnd = owner_;
    icon.uID = icon_id;
    icon.uFlags = NIF_MESSAGE | NIF_ICON | NIF_TIP | NIF_SHOWTIP;
    icon.uCallbackMessage = message_;
    icon.hIcon = icon_.raw();
    icon.uVersion = NOTIFYICON_VERSION_4;
    std::ranges::copy(shortened(tip_, std::size(icon.szTip) - 1), icon.szTip);
    return icon;
}

void TrayIcon::load_icon() {
    const UINT dpi = std::max(96U, ::GetDpiForWindow(owner_));
    const int width = ::GetSystemMetricsForDpi(SM_CXSMICON, dpi);
    const int height = ::GetSystemMetricsForDpi(SM_CYSMICON, dpi);
    const HANDLE loaded = ::LoadImageW(
        ::GetModuleHandleW(nullptr),
        MAKEINTRESOURCEW(HYRAX_ICON),
        IMAGE_ICON,
        width,
        height,
        LR_DEFAULTCOLOR
    );
    if (loaded != nullptr) {
        icon_ = Icon(static_cast<HICON>(loaded));
    }
}

/// The icon may still exist: TaskbarCreated comes for a changed DPI, too, and to add an icon that
/// is there fails for ever.
void TrayIcon::put(Ticks now) {
    NOTIFYICONDATAW icon = data();
    shown_ = shell_(NIM_MODIFY, icon) || shell_(NIM_ADD, icon);
    retry_at_ = never;
    if (shown_) {
        failed_attempts_ = 0;
        shell_(NIM_SETVERSION, icon);
    } else if (failed_attempts_ < retry_after.size()) {
        retry_at_ = now + retry_after[failed_attempts_++];
    } else {
        spdlog::warn("there is no notification area for the tray icon");
    }
}

void TrayIcon::retry(Ticks now) {
    if (now >= retry_at_) {
        put(now);
    }
}

void TrayIcon::renew(Ticks now) {
    load_icon();
    failed_attempts_ = 0;
    put(now);
}

void TrayIcon::set_tip(const std::wstring& tip) {
    if (tip == tip_) {
        return;
    }
    tip_ = tip;
    if (shown_) {
        NOTIFYICONDATAW icon = data();
        shell_(NIM_MODIFY, icon);
    }
}

void TrayIcon::notify(const std::wstring& title, const std::wstring& text) {
    if (!shown_) {
        return;
    }
    NOTIFYICONDATAW icon = data();
    icon.uFlags |= NIF_INFO;
    icon.dwInfoFlags = NIIF_INFO | NIIF_RESPECT_QUIET_TIME;
    std::ranges::copy(shortened(title, std::size(icon.szInfoTitle) - 1), icon.szInfoTitle);
    std::ranges::copy(shortened(text, std::size(icon.szInfo) - 1), icon.szInfo);
    shell_(NIM_MODIFY, icon);
}

void TrayIcon::take_focus() {
    NOTIFYICONDATAW icon = data();
    shell_(NIM_SETFOCUS, icon);
}

}  // namespace hyrax::win32
