// SPDX-License-Identifier: MIT
// Where a daemon's control socket lies: one for each user and profile.
#pragma once

#include "daemon/core/result.h"

#include <filesystem>

namespace hyrax {

/// `$XDG_RUNTIME_DIR/hyrax/<hash of the profile's folder>.socket`. Makes nothing. Fails without
/// XDG_RUNTIME_DIR, and where the path would be longer than a socket's can be.
[[nodiscard]] Result<std::filesystem::path> control_path(const std::filesystem::path& profile);

/// Makes the folder of sockets, or sees that it is this user's own and nobody else may enter.
[[nodiscard]] Result<void> prepare_control_folder(const std::filesystem::path& folder);

/// The folder that the running program lies in.
std::filesystem::path program_folder();

}  // namespace hyrax
