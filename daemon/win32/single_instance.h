// SPDX-License-Identifier: MIT
// One daemon for each user and profile: a second start gives its arguments to the first.
#pragma once

#include "daemon/core/result.h"
#include "daemon/win32/handle.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hyrax::win32 {

/// The name of the profile's daemon, for this user: "hyrax-" and a hash.
[[nodiscard]] Result<std::wstring> instance_name(const std::filesystem::path& profile);

class SingleInstance {
public:
    /// Takes the place of the profile's daemon if it is free, until the process ends.
    [[nodiscard]] static Result<SingleInstance> claim(const std::filesystem::path& profile);

    bool is_first() const { return first_; }
    /// For Win32DesktopOptions: by this name a second start finds the first one's window.
    const std::wstring& name() const { return name_; }

    /// Waits up to 2 s for the first daemon to come up and up to 5 s for its answer.
    [[nodiscard]] Result<void> hand_over(std::span<const std::string> arguments) const;

private:
    SingleInstance() = default;

    KernelObject mutex_;
    std::wstring name_;
    bool first_ = false;
};

/// What a WM_COPYDATA message holds, if it comes from hand_over().
std::optional<std::vector<std::string>> handed_over_arguments(LPARAM copy_data);

/// The class of the daemon's window.
inline constexpr const wchar_t* daemon_window_class = L"hyrax.daemon";

}  // namespace hyrax::win32
