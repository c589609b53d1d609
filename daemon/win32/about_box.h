// SPDX-License-Identifier: MIT
// The about box: stays open beside the running pets.
#pragma once

#include "daemon/win32/handle.h"

namespace hyrax::win32 {

/// Modeless: its messages come through the daemon's own loop, by way of takes().
class AboutBox {
public:
    /// `modal_owner` gets the message with wparam 1 while the system moves the box or shows its
    /// menu in a loop of its own, and with 0 afterwards.
    AboutBox(HWND modal_owner, UINT message) : owner_(modal_owner), message_(message) {}
    AboutBox(const AboutBox&) = delete;
    AboutBox& operator=(const AboutBox&) = delete;

    /// Brings it to the front if it is open already.
    void open();
    /// True for messages that were for the box and have been treated.
    bool takes(MSG& message) const;

private:
    static INT_PTR CALLBACK
    procedure(HWND box, UINT message, WPARAM wparam, LPARAM lparam) noexcept;

    HWND owner_;
    UINT message_;
    Window box_;
};

}  // namespace hyrax::win32
