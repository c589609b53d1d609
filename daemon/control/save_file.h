// SPDX-License-Identifier: MIT
// How the daemon writes config.json; the system's room knows a way that survives crashes.
#pragma once

#include "daemon/core/result.h"

#include <filesystem>
#include <functional>
#include <string_view>

namespace hyrax {

/// Replaces a file by this text, so that it is on the disk, whole, when the call returns. Does not
/// wait for another program that holds the file.
using SaveFile = std::function<Result<void>(const std::filesystem::path&, std::string_view)>;

/// The code of a refusal that may pass: another program holds the file for a moment.
inline constexpr std::string_view not_saved = "not_saved";

}  // namespace hyrax
