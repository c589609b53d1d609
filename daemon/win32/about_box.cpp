// SPDX-License-Identifier: MIT
#include "daemon/win32/about_box.h"

#include "daemon/win32/resources/ids.h"

namespace hyrax::win32 {

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
        return TRUE;
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
