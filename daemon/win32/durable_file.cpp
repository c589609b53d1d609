// SPDX-License-Identifier: MIT
#include "daemon/win32/durable_file.h"

#include "daemon/core/files.h"
#include "daemon/win32/handle.h"
#include "daemon/win32/text.h"

namespace hyrax::win32 {
namespace {

bool write_new(const std::filesystem::path& path, std::string_view text) {
    const KernelObject file = owned_file(::CreateFileW(
        path.c_str(), GENERIC_WRITE, 0, nullptr, CREATE_ALWAYS, FILE_ATTRIBUTE_NORMAL, nullptr
    ));
    DWORD written = 0;
    return file &&
           ::WriteFile(
               file.raw(), text.data(), static_cast<DWORD>(text.size()), &written, nullptr
           ) != 0 &&
           written == text.size() && ::FlushFileBuffers(file.raw()) != 0;
}

bool put_in_place(const std::filesystem::path& fresh, const std::filesystem::path& path) {
    if (::ReplaceFileW(path.c_str(), fresh.c_str(), nullptr, 0, nullptr, nullptr) != 0) {
        return true;
    }
    return ::GetLastError() == ERROR_FILE_NOT_FOUND &&
           ::MoveFileExW(fresh.c_str(), path.c_str(), MOVEFILE_WRITE_THROUGH) != 0;
}

}  // namespace

Result<void> save_file(const std::filesystem::path& path, std::string_view text) {
    std::filesystem::path fresh = path;
    fresh += L".new";
    if (write_new(fresh, text) && put_in_place(fresh, path)) {
        return {};
    }
    const DWORD code = ::GetLastError();
    ::DeleteFileW(fresh.c_str());
    return std::unexpected(system_error(utf8_from_path(path) + ": cannot be replaced", code));
}

}  // namespace hyrax::win32
