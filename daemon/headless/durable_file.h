// SPDX-License-Identifier: MIT
// Files that survive a crash in the middle of writing.
#pragma once

#include "daemon/core/result.h"

#include <filesystem>
#include <string_view>

namespace hyrax {

/// Replaces the file, or the one that a link leads to: whoever reads it, even after a power cut,
/// sees the old or the new text, never a part. Keeps its mode. Uses "<path>.new".
[[nodiscard]] Result<void> save_file(const std::filesystem::path& path, std::string_view text);

}  // namespace hyrax
