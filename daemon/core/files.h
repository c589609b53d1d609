// SPDX-License-Identifier: MIT
// Whole small files in and out. Every message begins with the file's name and says what is wrong.
#pragma once

#include "daemon/core/result.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

/// Reads an ordinary file. Fails at once, without reading, on one that is missing, a folder, a
/// device or larger than `max_bytes`. Contents are not checked, but a UTF-8 mark at the start (as
/// Windows Notepad writes it) is left out.
[[nodiscard]] Result<std::string> read_text_file(
    const std::filesystem::path& path, std::size_t max_bytes
);

/// The same, with every byte kept.
[[nodiscard]] Result<std::vector<std::byte>> read_binary_file(
    const std::filesystem::path& path, std::size_t max_bytes
);

/// Replaces the file: whoever reads it meanwhile sees the old or the new text, never a part. The
/// folder must exist. Uses "<path>.new", which is gone afterwards.
[[nodiscard]] Result<void> write_file_atomically(
    const std::filesystem::path& path, std::string_view text
);

/// A text that is another one when a file below the folder has come, gone or been written; empty
/// if there is none. Links to folders are not followed.
std::string stamp_of_folder(const std::filesystem::path& folder);

/// The path for messages and JSON, in UTF-8 on every system.
std::string utf8_from_path(const std::filesystem::path& path);

/// The path that a UTF-8 text names. Never in the code page of the system, unlike path's own
/// constructor on Windows.
std::filesystem::path path_from_utf8(std::string_view text);

}  // namespace hyrax
