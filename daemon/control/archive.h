// SPDX-License-Identifier: MIT
// Zip files of strangers: what of them may reach the disk.
#pragma once

#include "daemon/core/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

struct ArchiveEntry {
    std::string name;  ///< As it stands in the archive, folders with a '/' at the end.
    bool is_link = false;
    bool is_encrypted = false;
};

/// An archive that is open.
class Archive {
public:
    /// Takes a piece of a file; a failure ends the reading.
    using Sink = std::function<Result<void>(std::string_view piece)>;

    Archive() = default;
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;
    virtual ~Archive() = default;

    /// Goes on with the next entry, the first one at first; false behind the last one.
    [[nodiscard]] virtual Result<bool> next(ArchiveEntry& entry) = 0;
    /// What is in the entry, piece by piece. Fails where its checksum is wrong.
    [[nodiscard]] virtual Result<void> read(const Sink& sink) = 0;
};

/// Fails for what is no zip file, and for one larger than a plugin may be. Held in memory.
[[nodiscard]] Result<std::unique_ptr<Archive>> open_archive(const std::filesystem::path& file);

/// The name as a path below a folder. Fails for absolute paths, "..", drives, devices, names that
/// some system would change, and others than of printable ASCII.
[[nodiscard]] Result<std::filesystem::path> safe_path(std::string_view name);

/// Puts the files into the folder, which must be empty. Fails for links, what is encrypted, names
/// that are not safe or differ in case alone, and above what a plugin may hold, counted as it
/// comes. What was written by then stays.
[[nodiscard]] Result<void> unpack(Archive& archive, const std::filesystem::path& folder);

}  // namespace hyrax
