// SPDX-License-Identifier: MIT
// The plugins of a profile as folders: new, installed, removed.
#pragma once

#include "daemon/core/plugin.h"
#include "daemon/core/result.h"

#include <filesystem>
#include <string>

namespace hyrax {

/// Where the plugins of a profile are.
std::filesystem::path plugins_of(const std::filesystem::path& profile);

/// Writes a plugin that works into a new folder `into`/`id`, and returns the folder. Fails for an
/// id that is none and for a folder that is there.
[[nodiscard]] Result<std::filesystem::path> new_plugin(
    const std::string& id, const std::filesystem::path& into
);

/// Puts a copy of a plugin, a folder or a zip file, into the profile. It is unpacked beside, read
/// and checked, and only then takes its place, all at once; nothing of it runs. Without `replace`,
/// a plugin of the same id that is there already is a failure.
[[nodiscard]] Result<Plugin> install_plugin(
    const std::filesystem::path& from, const std::filesystem::path& profile, bool replace
);

/// Removes the folder of a plugin, and nothing else.
[[nodiscard]] Result<void> remove_plugin(
    const std::string& id, const std::filesystem::path& profile
);

}  // namespace hyrax
