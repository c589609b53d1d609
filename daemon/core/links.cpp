// SPDX-License-Identifier: MIT
#include "daemon/core/links.h"

namespace hyrax {

namespace fs = std::filesystem;

void remove_tree(const fs::path& path, std::error_code& error) {
    error.clear();
    if (!is_link(path) && fs::is_directory(fs::symlink_status(path, error))) {
        for (const fs::directory_entry& entry : fs::directory_iterator(path, error)) {
            remove_tree(entry.path(), error);
            if (error) {
                return;
            }
        }
    }
    if (!error || error == std::errc::no_such_file_or_directory) {
        fs::remove(path, error);
    }
}

}  // namespace hyrax
