// SPDX-License-Identifier: MIT
#include "daemon/core/links.h"

namespace hyrax {

namespace fs = std::filesystem;

bool is_link(const fs::path& path) {
    std::error_code error;
    return fs::is_symlink(path, error);
}

fs::path real_path(const fs::path& path) {
    std::error_code error;
    fs::path real = fs::canonical(path, error);
    return error ? fs::path() : real;
}

}  // namespace hyrax
