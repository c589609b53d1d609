// SPDX-License-Identifier: MIT
// The process and its folders.
#pragma once

#include "daemon/core/result.h"

#include <filesystem>

namespace hyrax::win32 {

/// First thing in wWinMain: DLLs come from the system's folder alone, and a damaged heap ends the
/// process instead of being used.
void harden_process();

/// For its quirks alone, each with a comment that names the symptom.
bool runs_under_wine();

struct Folders {
    std::filesystem::path executable;
    std::filesystem::path program;  ///< Of the executable.
    std::filesystem::path profile;  ///< config.json, scripts and sprites of the user.
    std::filesystem::path state;    ///< Logs and what the daemon remembers.
    bool portable = false;          ///< Everything lies beside the executable.
};

/// %APPDATA%\hyrax and %LOCALAPPDATA%\hyrax, or the program's own folder when a file named
/// `hyrax.portable` lies in it and files can be made there. Creates nothing.
[[nodiscard]] Result<Folders> find_folders();

/// Opens a file with the program that the user has for it, else with Notepad. May take seconds;
/// for a thread that may block.
[[nodiscard]] Result<void> open_in_editor(const std::filesystem::path& file);
/// The same for a folder, in Explorer.
[[nodiscard]] Result<void> open_folder(const std::filesystem::path& folder);

}  // namespace hyrax::win32
