// SPDX-License-Identifier: MIT
#include "daemon/win32/console.h"

#include "daemon/win32/text.h"

#include <windows.h>

namespace hyrax::win32 {
namespace {

bool write_to(HANDLE output, std::string_view text) {
    DWORD written = 0;
    return output != nullptr && output != INVALID_HANDLE_VALUE &&
           ::WriteFile(output, text.data(), static_cast<DWORD>(text.size()), &written, nullptr) !=
               0;
}

}  // namespace

void say(std::string_view text) {
    if (write_to(::GetStdHandle(STD_OUTPUT_HANDLE), text)) {
        return;
    }
    if (::AttachConsole(ATTACH_PARENT_PROCESS) != 0) {
        const bool written = write_to(::GetStdHandle(STD_OUTPUT_HANDLE), text);
        ::FreeConsole();
        if (written) {
            return;
        }
    }
    ::MessageBoxW(nullptr, wide(text).c_str(), L"hyrax", MB_OK | MB_SETFOREGROUND);
}

}  // namespace hyrax::win32
