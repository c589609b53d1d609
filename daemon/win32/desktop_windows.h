// SPDX-License-Identifier: MIT
// The windows of other programs, as they stand on the desktop now.
#pragma once

#include "daemon/core/ledges.h"
#include "daemon/win32/handle.h"

#include <cstdint>
#include <vector>

namespace hyrax::win32 {

inline std::uint64_t id_of(HWND window) {
    return reinterpret_cast<std::uintptr_t>(window);
}
inline HWND window_with(std::uint64_t id) {
    return reinterpret_cast<HWND>(id);
}

/// Reads what the window manager knows of them. The compositor's part is asked of dwmapi.dll, which
/// is loaded with the first reading.
class DesktopWindows {
public:
    /// All that are shown, the topmost first; our own are not among them.
    std::vector<DesktopWindow> read();

private:
    using Attribute = HRESULT(WINAPI*)(HWND, DWORD, void*, DWORD);

    static BOOL CALLBACK add_window(HWND window, LPARAM reading) noexcept;
    bool is_cloaked(HWND window) const;
    RECT frame_of(HWND window) const;

    Library library_;
    Attribute attribute_ = nullptr;
    bool loaded_ = false;
};

}  // namespace hyrax::win32
