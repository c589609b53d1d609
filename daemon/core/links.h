// SPDX-License-Identifier: MIT
// What names in the file system lead elsewhere. Each system has its own file: the standard library
// of mingw-w64 follows Windows' links without knowing that they are there.
#pragma once

#include <filesystem>
#include <system_error>

namespace hyrax {

/// A symbolic link or, on Windows, any other name that stands for another, such as a junction.
bool is_link(const std::filesystem::path& path);

/// Where the path leads once every link has been followed; for comparing with others of the kind
/// alone. Empty if it leads nowhere.
std::filesystem::path real_path(const std::filesystem::path& path);

/// Removes a file or a folder with all that is in it: links, never what they lead to.
void remove_tree(const std::filesystem::path& path, std::error_code& error);

}  // namespace hyrax
