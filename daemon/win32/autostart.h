// SPDX-License-Identifier: MIT
// Starting with the user's session: the Run key, and the switch that Windows' own settings keep
// beside it.
#pragma once

#include "daemon/core/result.h"

#include <filesystem>
#include <optional>
#include <string>

namespace hyrax::win32 {

class Autostart {
public:
    /// `key` below HKEY_CURRENT_USER holds Run and Explorer\StartupApproved\Run; a test brings its
    /// own. Touches nothing until set() is called.
    explicit Autostart(
        std::filesystem::path program,
        std::wstring key = L"Software\\Microsoft\\Windows\\CurrentVersion"
    );

    /// True when an entry of our name is there and Windows' settings have not switched it off.
    bool is_on() const;
    /// On: the entry starts this program with --autostart. Off: the entry goes.
    [[nodiscard]] Result<void> set(bool on) const;
    /// What stands in the entry, quoted: a path with blanks would start something else.
    std::wstring command() const;

    /// Asks Windows to start the program once more with these arguments when an update had to end
    /// it, or when it crashed. Not after a restart of the machine if the session starts it anyway.
    void offer_restart(const std::wstring& arguments) const;

private:
    std::filesystem::path program_;
    std::wstring run_;
    std::wstring approved_;
};

/// Of a start that asks for nothing, with this profile if it is not the usual one.
std::wstring restart_arguments(const std::optional<std::filesystem::path>& profile);

}  // namespace hyrax::win32
