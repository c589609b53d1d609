// SPDX-License-Identifier: MIT
#include "daemon/win32/pipe_name.h"

#include "daemon/win32/text.h"
#include "daemon/win32/user.h"

#include <aclapi.h>
#include <sddl.h>

namespace hyrax::win32 {

Result<std::wstring> pipe_name(const std::wstring& instance) {
    DWORD session = 0;
    if (::ProcessIdToSessionId(::GetCurrentProcessId(), &session) == 0) {
        return std::unexpected(system_error("cannot tell the session"));
    }
    return LR"(\\.\pipe\)" + instance + L"-s" + std::to_wstring(session);
}

Result<LocalMemory> pipe_security() {
    const Result<std::wstring> user = user_sid();
    if (!user) {
        return std::unexpected(user.error());
    }
    // Owner; a protected list of one entry, all rights; medium integrity, no writing from below.
    const std::wstring text = L"O:" + *user + L"D:P(A;;GA;;;" + *user + L")S:(ML;;NW;;;ME)";
    PSECURITY_DESCRIPTOR descriptor = nullptr;
    if (::ConvertStringSecurityDescriptorToSecurityDescriptorW(
            text.c_str(), SDDL_REVISION_1, &descriptor, nullptr
        ) == 0) {
        return std::unexpected(system_error("cannot protect the control pipe"));
    }
    return LocalMemory(descriptor);
}

Result<void> check_owner(HANDLE object) {
    const Result<std::wstring> user = user_sid();
    if (!user) {
        return std::unexpected(user.error());
    }
    PSID owner = nullptr;
    PSECURITY_DESCRIPTOR descriptor = nullptr;
    const DWORD code = ::GetSecurityInfo(
        object,
        SE_KERNEL_OBJECT,
        OWNER_SECURITY_INFORMATION,
        &owner,
        nullptr,
        nullptr,
        nullptr,
        &descriptor
    );
    const LocalMemory memory(descriptor);
    wchar_t* text = nullptr;
    if (code != ERROR_SUCCESS || ::ConvertSidToStringSidW(owner, &text) == 0) {
        return std::unexpected(system_error("cannot tell whose pipe this is", code));
    }
    const LocalMemory owned(text);
    if (*user != text) {
        return failure("the control pipe belongs to another user");
    }
    return {};
}

}  // namespace hyrax::win32
