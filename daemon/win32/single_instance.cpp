// SPDX-License-Identifier: MIT
#include "daemon/win32/single_instance.h"

#include "daemon/win32/argument_packing.h"
#include "daemon/win32/text.h"
#include "daemon/win32/user.h"

#include <cstdint>
#include <cwctype>
#include <string_view>

namespace hyrax::win32 {

namespace {

/// Tells our messages from those of other programs.
constexpr ULONG_PTR copy_data_mark = 0x48595258;  // "HYRX"

/// FNV-1a: names of kernel objects may hold neither backslashes nor more than 260 characters.
std::uint64_t hash_of(std::wstring_view text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const wchar_t unit : text) {
        hash = (hash ^ static_cast<std::uint64_t>(unit)) * 0x100000001b3U;
    }
    return hash;
}

std::wstring hexadecimal(std::uint64_t value) {
    std::wstring digits(16, L'0');
    for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, value >>= 4U) {
        *digit = L"0123456789abcdef"[value & 0xFU];
    }
    return digits;
}

std::wstring name_for(const std::wstring& user, const std::filesystem::path& profile) {
    std::error_code ignored;
    std::wstring path = std::filesystem::weakly_canonical(profile, ignored).wstring();
    if (ignored) {
        path = profile.wstring();
    }
    for (wchar_t& unit : path) {
        unit = static_cast<wchar_t>(std::towlower(static_cast<std::wint_t>(unit)));
    }
    return L"hyrax-" + hexadecimal(hash_of(user + L'|' + path));
}

/// The first daemon holds the mutex a moment before its window is there.
HWND find_daemon(const std::wstring& name) {
    constexpr int attempts = 40;
    for (int i = 0; i < attempts; ++i) {
        if (const HWND window = ::FindWindowW(daemon_window_class, name.c_str())) {
            return window;
        }
        ::Sleep(50);
    }
    return nullptr;
}

}  // namespace

Result<std::wstring> instance_name(const std::filesystem::path& profile) {
    const Result<std::wstring> user = user_sid();
    return user ? Result<std::wstring>(name_for(*user, profile)) : user;
}

Result<SingleInstance> SingleInstance::claim(const std::filesystem::path& profile) {
    Result<std::wstring> name = instance_name(profile);
    if (!name) {
        return std::unexpected(name.error());
    }
    SingleInstance instance;
    instance.name_ = *std::move(name);
    instance.mutex_ =
        KernelObject(::CreateMutexW(nullptr, FALSE, (L"Local\\" + instance.name_).c_str()));
    const DWORD outcome = ::GetLastError();
    if (!instance.mutex_ && outcome != ERROR_ACCESS_DENIED) {
        return std::unexpected(system_error("cannot tell whether hyrax runs already", outcome));
    }
    // Access is denied when the other one runs with more rights than this one.
    instance.first_ = instance.mutex_ && outcome != ERROR_ALREADY_EXISTS;
    return instance;
}

Result<void> SingleInstance::hand_over(std::span<const std::string> arguments) const {
    const HWND daemon = find_daemon(name_);
    if (daemon == nullptr) {
        return failure("hyrax runs already, but its window was not found");
    }
    std::optional<std::string> packed = pack_arguments(arguments);
    if (!packed) {
        return failure("the arguments are too long for the hyrax that runs already");
    }
    DWORD process = 0;
    ::GetWindowThreadProcessId(daemon, &process);
    ::AllowSetForegroundWindow(process);

    COPYDATASTRUCT data{};
    data.dwData = copy_data_mark;
    data.cbData = static_cast<DWORD>(packed->size());
    data.lpData = packed->data();
    DWORD_PTR accepted = 0;
    const LRESULT answered = ::SendMessageTimeoutW(
        daemon, WM_COPYDATA, 0, reinterpret_cast<LPARAM>(&data), SMTO_ABORTIFHUNG, 5000, &accepted
    );
    if (answered == 0) {
        return std::unexpected(system_error("the hyrax that runs already does not answer"));
    }
    if (accepted == 0) {
        return failure("the hyrax that runs already refuses the arguments");
    }
    return {};
}

std::optional<std::vector<std::string>> handed_over_arguments(LPARAM copy_data) {
    const auto* const data = reinterpret_cast<const COPYDATASTRUCT*>(copy_data);
    if (data == nullptr || data->dwData != copy_data_mark ||
        (data->lpData == nullptr && data->cbData != 0)) {
        return std::nullopt;
    }
    return unpack_arguments({static_cast<const char*>(data->lpData), data->cbData});
}

}  // namespace hyrax::win32
