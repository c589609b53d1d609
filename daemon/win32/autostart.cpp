// SPDX-License-Identifier: MIT
#include "daemon/win32/autostart.h"

#include "daemon/win32/text.h"

#include <spdlog/spdlog.h>

#include <array>
#include <utility>

namespace hyrax::win32 {

namespace {

constexpr const wchar_t* entry = L"hyrax";

Result<void> succeeded(LSTATUS status, const char* what) {
    if (status == ERROR_SUCCESS) {
        return {};
    }
    return std::unexpected(system_error(what, static_cast<DWORD>(status)));
}

LSTATUS remove_value(const std::wstring& key) {
    const LSTATUS status = ::RegDeleteKeyValueW(HKEY_CURRENT_USER, key.c_str(), entry);
    return status == ERROR_FILE_NOT_FOUND ? ERROR_SUCCESS : status;
}

/// Twelve bytes, undocumented: the first one is odd when the user has switched the entry off in
/// the task manager or the settings; the last eight are the time of that, or zero.
bool is_disapproved(const std::wstring& key) {
    std::array<BYTE, 12> state{};
    DWORD size = static_cast<DWORD>(state.size());
    const LSTATUS status = ::RegGetValueW(
        HKEY_CURRENT_USER, key.c_str(), entry, RRF_RT_REG_BINARY, nullptr, state.data(), &size
    );
    return status == ERROR_SUCCESS && (state[0] & 1U) != 0;
}

}  // namespace

Autostart::Autostart(std::filesystem::path program, std::wstring key)
    : program_(std::move(program)),
      run_(key + L"\\Run"),
      approved_(key + L"\\Explorer\\StartupApproved\\Run") {}

std::wstring Autostart::command() const {
    return L'"' + program_.wstring() + L"\" --autostart";
}

bool Autostart::is_on() const {
    const LSTATUS status = ::RegGetValueW(
        HKEY_CURRENT_USER, run_.c_str(), entry, RRF_RT_REG_SZ, nullptr, nullptr, nullptr
    );
    return status == ERROR_SUCCESS && !is_disapproved(approved_);
}

Result<void> Autostart::set(bool on) const {
    // Else an entry that was once switched off in Windows' settings would stay off.
    if (const auto cleared = succeeded(remove_value(approved_), "autostart"); !cleared) {
        return cleared;
    }
    if (!on) {
        return succeeded(remove_value(run_), "autostart: the entry cannot be removed");
    }
    const std::wstring text = command();
    const auto bytes = static_cast<DWORD>((text.size() + 1) * sizeof(wchar_t));
    return succeeded(
        ::RegSetKeyValueW(HKEY_CURRENT_USER, run_.c_str(), entry, REG_SZ, text.c_str(), bytes),
        "autostart: the entry cannot be written"
    );
}

void Autostart::offer_restart(const std::wstring& arguments) const {
    const DWORD flags = is_on() ? DWORD{RESTART_NO_REBOOT} : 0;
    if (const HRESULT done = ::RegisterApplicationRestart(arguments.c_str(), flags); FAILED(done)) {
        spdlog::warn(
            "Windows will not start hyrax again after an update (error {:#x})",
            static_cast<unsigned>(done)
        );
    }
}

std::wstring restart_arguments(const std::optional<std::filesystem::path>& profile) {
    std::wstring arguments = L"--autostart";
    if (profile) {
        std::wstring folder = profile->wstring();
        // A single one before the closing quote would make that a part of the name.
        if (folder.ends_with(L'\\')) {
            folder += L'\\';
        }
        arguments += L" --profile \"" + folder + L'"';
    }
    return arguments;
}

}  // namespace hyrax::win32
