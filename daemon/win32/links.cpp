// SPDX-License-Identifier: MIT
#include "daemon/core/links.h"

#include "daemon/win32/handle.h"

#include <windows.h>

#include <string>

namespace hyrax {
namespace {

namespace fs = std::filesystem;
using win32::KernelObject;
using win32::owned_file;

using FindHandle = win32::Handle<HANDLE, ::FindClose>;

// In one form of names; empty if the volume has none of them.
std::wstring final_name(HANDLE file, DWORD form) {
    std::wstring name(MAX_PATH, L'\0');
    DWORD length =
        ::GetFinalPathNameByHandleW(file, name.data(), static_cast<DWORD>(name.size()), form);
    if (length > name.size()) {
        name.resize(length);
        length =
            ::GetFinalPathNameByHandleW(file, name.data(), static_cast<DWORD>(name.size()), form);
    }
    name.resize(length < name.size() ? length : 0);
    return name;
}

}  // namespace

bool is_link(const fs::path& path) {
    WIN32_FIND_DATAW data{};
    const HANDLE found = ::FindFirstFileW(path.c_str(), &data);
    if (found == INVALID_HANDLE_VALUE) {
        return false;
    }
    const FindHandle owner(found);
    // Files that lie in a cloud have a tag as well, but are what they seem. Wine tells no tag.
    const DWORD tag = data.dwReserved0;
    return (data.dwFileAttributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0 &&
           (tag == 0 || IsReparseTagNameSurrogate(tag));
}

fs::path real_path(const fs::path& path) {
    constexpr DWORD share = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
    // The flag opens folders, too.
    const KernelObject file = owned_file(::CreateFileW(
        path.c_str(), 0, share, nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr
    ));
    if (!file) {
        return {};
    }
    const std::wstring name = final_name(file.raw(), VOLUME_NAME_DOS);
    // Volumes without a letter.
    return name.empty() ? final_name(file.raw(), VOLUME_NAME_NT) : name;
}

}  // namespace hyrax
