// SPDX-License-Identifier: MIT
// Files that survive a crash in the middle of writing.
#pragma once

#include "daemon/core/result.h"

#include <filesystem>
#include <string_view>

namespace hyrax::win32 {

/// Replaces the file: whoever reads it, even after a power cut, sees the old or the new text, never
/// a part. Keeps its attributes and rights. Uses "<path>.new". Fails at once while another program
/// holds the file; who can wait may try again.
[[nodiscard]] Result<void> save_file(const std::filesystem::path& path, std::string_view text);

}  // namespace hyrax::win32
