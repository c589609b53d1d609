// SPDX-License-Identifier: MIT
// Zip files: Windows itself opens them, this program does not.
#include "daemon/control/archive.h"
#include "daemon/core/files.h"

namespace hyrax {

Result<std::unique_ptr<Archive>> open_archive(const std::filesystem::path& file) {
    return failure(
        utf8_from_path(file) +
        ": is no folder, and zip files are not opened on Windows: unpack it, and give its folder"
    );
}

}  // namespace hyrax
