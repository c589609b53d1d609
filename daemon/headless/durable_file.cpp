// SPDX-License-Identifier: MIT
#include "daemon/headless/durable_file.h"

#include "daemon/headless/file_descriptor.h"
#include "daemon/headless/system_error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>

namespace hyrax {
namespace {

namespace fs = std::filesystem;

bool write_all(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(file, text.data(), text.size());
        if (written < 0 && errno != EINTR) {
            return false;
        }
        text.remove_prefix(static_cast<std::size_t>(written < 0 ? 0 : written));
    }
    return true;
}

mode_t mode_of(const fs::path& path) {
    struct stat found {};
    return ::stat(path.c_str(), &found) == 0 ? found.st_mode & 07777U : 0644U;
}

}  // namespace

Result<void> save_file(const fs::path& given, std::string_view text) {
    std::error_code code;
    fs::path path = fs::canonical(given, code);
    path = code ? given : path;
    const fs::path fresh = path.native() + ".new";
    const int flags = O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW;
    const FileDescriptor file(::open(fresh.c_str(), flags, S_IRUSR | S_IWUSR));
    const bool written = file && write_all(file.raw(), text) &&
                         ::fchmod(file.raw(), mode_of(path)) == 0 && ::fsync(file.raw()) == 0;
    if (!written || std::rename(fresh.c_str(), path.c_str()) != 0) {
        const int reason = errno;
        ::unlink(fresh.c_str());
        return system_failure(path.native() + ": cannot be replaced", reason);
    }
    // The new name has to be on the disk as well; some file systems cannot tell.
    const FileDescriptor folder(
        ::open(path.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)
    );
    ::fsync(folder.raw());
    return {};
}

}  // namespace hyrax
