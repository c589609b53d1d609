// SPDX-License-Identifier: MIT
#include "daemon/win32/about_box.h"

#include "daemon/win32/resources/ids.h"
#include "daemon/win32/text.h"

#include <exception>
#include <string>
#include <string_view>

namespace hyrax::win32 {

namespace {

/// The licences of everything that is linked in, as the resources hold them: UTF-8, lines end in
/// \n.
std::wstring licences() {
    const HMODULE program = ::GetModuleHandleW(nullptr);
    const HRSRC found = ::FindResourceW(program, MAKEINTRESOURCEW(HYRAX_LICENCES), RT_RCDATA);
    const HGLOBAL loaded = found != nullptr ? ::LoadResource(program, found) : nullptr;
    if (loaded == nullptr) {
        return {};
    }
    const std::string_view text(
        static_cast<const char*>(::LockResource(loaded)), ::SizeofResource(program, found)
    );
    std::string lines;
    for (const char c : text) {
        if (c != '\r') {
            lines += c == '\n' ? std::string("\r\n") : std::string(1, c);
        }
    }
    return wide(lines);
}

}  // namespace

void AboutBox::open() {
    if (!box_) {
        box_ = Window(::CreateDialogParamW(
            ::GetModuleHandleW(nullptr),
            MAKEINTRESOURCEW(HYRAX_ABOUT),
            nullptr,
            procedure,
            reinterpret_cast<LPARAM>(this)
        ));
    }
    ::ShowWindow(box_.raw(), SW_SHOW);
    ::SetForegroundWindow(box_.raw());
}

bool AboutBox::takes(MSG& message) const {
    return box_ && ::IsDialogMessageW(box_.raw(), &message) != 0;
}

INT_PTR CALLBACK
AboutBox::procedure(HWND box, UINT message, WPARAM wparam, LPARAM lparam) noexcept {
    if (message == WM_INITDIALOG) {
        ::SetWindowLongPtrW(box, GWLP_USERDATA, lparam);
        try {
            ::SetDlgItemTextW(box, HYRAX_LICENCES_BOX, licences().c_str());
        } catch (const std::exception&) {
            return TRUE;  // Without the text: there is no memory.
        }
        // Else the text has the focus, and stands selected and scrolled to its end.
        ::SetFocus(::GetDlgItem(box, IDOK));
        return FALSE;
    }
    const auto* const self =
        reinterpret_cast<const AboutBox*>(::GetWindowLongPtrW(box, GWLP_USERDATA));
    if (self == nullptr) {
        return FALSE;
    }
    switch (message) {
        case WM_ENTERSIZEMOVE:
        case WM_ENTERMENULOOP:
            ::SendMessageW(self->owner_, self->message_, 1, 0);
            return TRUE;
        case WM_EXITSIZEMOVE:
        case WM_EXITMENULOOP:
            ::SendMessageW(self->owner_, self->message_, 0, 0);
            return TRUE;
        case WM_COMMAND:
            // Hidden, not destroyed: this runs inside a call on the window.
            if (LOWORD(wparam) == IDOK || LOWORD(wparam) == IDCANCEL) {
                ::ShowWindow(box, SW_HIDE);
            }
            return TRUE;
        default:
            return FALSE;
    }
}

}  // namespace hyrax::win32
