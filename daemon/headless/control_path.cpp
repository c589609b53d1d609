// SPDX-License-Identifier: MIT
#include "daemon/headless/control_path.h"

#include "daemon/headless/system_error.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace hyrax {
namespace {

namespace fs = std::filesystem;

// FNV-1a: a path may be longer than a socket's name.
std::uint64_t hash_of(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char byte : text) {
        hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    }
    return hash;
}

}  // namespace

Result<fs::path> control_path(const fs::path& profile) {
    const char* const runtime = std::getenv("XDG_RUNTIME_DIR");
    if (runtime == nullptr || !fs::path(runtime).is_absolute()) {
        return failure("XDG_RUNTIME_DIR is not set: there is no place for the control socket");
    }
    std::error_code code;
    fs::path folder = fs::canonical(profile, code);
    if (code) {
        folder = fs::absolute(profile);
    }
    const fs::path path =
        fs::path(runtime) / "hyrax" / fmt::format("{:016x}.socket", hash_of(folder.native()));
    if (path.native().size() >= sizeof sockaddr_un{}.sun_path) {
        return failure(fmt::format("{}: is too long a path for a socket", path.native()));
    }
    return path;
}

Result<void> prepare_control_folder(const fs::path& folder) {
    if (::mkdir(folder.c_str(), S_IRWXU) != 0 && errno != EEXIST) {
        return system_failure(folder.native() + ": cannot be made");
    }
    struct stat found {};
    if (::lstat(folder.c_str(), &found) != 0) {
        return system_failure(folder.native() + ": cannot be read");
    }
    if (!S_ISDIR(found.st_mode) || found.st_uid != ::geteuid() ||
        (found.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
        return failure(fmt::format(
            "{}: must be a folder of yours that nobody else may enter (mode 0700)", folder.native()
        ));
    }
    return {};
}

fs::path program_folder() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path();
}

}  // namespace hyrax
