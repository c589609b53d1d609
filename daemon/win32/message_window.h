// SPDX-License-Identifier: MIT
// Windows whose messages go to an object: the border between the system's calls and our code.
#pragma once

#include "daemon/core/result.h"
#include "daemon/win32/handle.h"

#include <optional>
#include <string>

namespace hyrax::win32 {

/// Gets the messages of one or more windows. Must outlive them. May throw: that ends at the border.
class MessageHandler {
public:
    /// Nothing: the system's default treatment.
    virtual std::optional<LRESULT> on_message(
        HWND window, UINT message, WPARAM wparam, LPARAM lparam
    ) = 0;

protected:
    ~MessageHandler() = default;
};

struct WindowPlan {
    const wchar_t* class_name = nullptr;
    std::wstring title;
    DWORD style = WS_POPUP;
    DWORD extended_style = 0;
};

/// A hidden top-level window of no size. Windows of one class share their cursor, an arrow.
[[nodiscard]] Result<Window> create_window(const WindowPlan& plan, MessageHandler& handler);

}  // namespace hyrax::win32
