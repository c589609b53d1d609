// SPDX-License-Identifier: MIT
#include "daemon/win32/user.h"

#include "daemon/win32/handle.h"
#include "daemon/win32/text.h"

#include <sddl.h>

#include <array>
#include <cstddef>

namespace hyrax::win32 {

Result<std::wstring> user_sid() {
    HANDLE opened = nullptr;
    if (::OpenProcessToken(::GetCurrentProcess(), TOKEN_QUERY, &opened) == 0) {
        return std::unexpected(system_error("cannot tell who the user is"));
    }
    const KernelObject token(opened);
    alignas(TOKEN_USER) std::array<std::byte, sizeof(TOKEN_USER) + SECURITY_MAX_SID_SIZE> buffer{};
    DWORD size = static_cast<DWORD>(buffer.size());
    wchar_t* text = nullptr;
    const auto* const user = reinterpret_cast<const TOKEN_USER*>(buffer.data());
    if (::GetTokenInformation(token.raw(), TokenUser, buffer.data(), size, &size) == 0 ||
        ::ConvertSidToStringSidW(user->User.Sid, &text) == 0) {
        return std::unexpected(system_error("cannot tell who the user is"));
    }
    const LocalMemory owner(text);
    return std::wstring(text);
}

}  // namespace hyrax::win32
