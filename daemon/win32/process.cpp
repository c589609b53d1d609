// SPDX-License-Identifier: MIT
#include "daemon/win32/process.h"

#include "daemon/win32/handle.h"
#include "daemon/win32/text.h"

#include <shellapi.h>
#include <shlobj.h>

#include <string>

namespace hyrax::win32 {

namespace {

Result<std::filesystem::path> program_path() {
    std::wstring buffer(MAX_PATH, L'\0');
    constexpr std::size_t longest = 32768;
    while (buffer.size() <= longest) {
        const DWORD size = static_cast<DWORD>(buffer.size());
        const DWORD length = ::GetModuleFileNameW(nullptr, buffer.data(), size);
        if (length == 0) {
            break;
        }
        if (length < size) {
            buffer.resize(length);
            return std::filesystem::path(buffer);
        }
        buffer.resize(2 * buffer.size());
    }
    return std::unexpected(system_error("cannot tell where the program lies"));
}

Result<std::filesystem::path> known_folder(const KNOWNFOLDERID& id, const char* name) {
    wchar_t* path = nullptr;
    const HRESULT result = ::SHGetKnownFolderPath(id, KF_FLAG_DEFAULT, nullptr, &path);
    const TaskMemory<wchar_t> owner(path);
    if (FAILED(result)) {
        return std::unexpected(
            system_error(std::string("cannot find ") + name, static_cast<DWORD>(result))
        );
    }
    return std::filesystem::path(path) / L"hyrax";
}

bool can_write_to(const std::filesystem::path& folder) {
    const std::filesystem::path probe = folder / L"hyrax.portable.probe";
    return static_cast<bool>(owned_file(::CreateFileW(
        probe.c_str(),
        GENERIC_WRITE,
        0,
        nullptr,
        CREATE_ALWAYS,
        FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE,
        nullptr
    )));
}

bool shell_open(const std::wstring& file, const wchar_t* arguments) {
    SHELLEXECUTEINFOW request{};
    request.cbSize = sizeof request;
    request.fMask = SEE_MASK_FLAG_NO_UI | SEE_MASK_NOASYNC;
    request.lpFile = file.c_str();
    request.lpParameters = arguments;
    request.nShow = SW_SHOWNORMAL;
    return ::ShellExecuteExW(&request) != 0;
}

}  // namespace

void harden_process() {
    ::SetDefaultDllDirectories(LOAD_LIBRARY_SEARCH_SYSTEM32);
    ::HeapSetInformation(nullptr, HeapEnableTerminationOnCorruption, nullptr, 0);
}

bool runs_under_wine() {
    const HMODULE ntdll = ::GetModuleHandleW(L"ntdll.dll");
    return ntdll != nullptr && ::GetProcAddress(ntdll, "wine_get_version") != nullptr;
}

Result<Folders> find_folders() {
    const Result<std::filesystem::path> program = program_path();
    if (!program) {
        return std::unexpected(program.error());
    }
    Folders folders;
    folders.executable = *program;
    folders.program = program->parent_path();
    std::error_code ignored;
    if (std::filesystem::exists(folders.program / L"hyrax.portable", ignored) &&
        can_write_to(folders.program)) {
        folders.profile = folders.program / L"profile";
        folders.state = folders.program / L"state";
        folders.portable = true;
        return folders;
    }
    const Result<std::filesystem::path> roaming =
        known_folder(FOLDERID_RoamingAppData, "%APPDATA%");
    const Result<std::filesystem::path> local =
        known_folder(FOLDERID_LocalAppData, "%LOCALAPPDATA%");
    if (!roaming || !local) {
        return std::unexpected(roaming ? local.error() : roaming.error());
    }
    folders.profile = *roaming;
    folders.state = *local;
    return folders;
}

Result<void> open_in_editor(const std::filesystem::path& file) {
    const ComSession com;
    const std::wstring quoted = L'"' + file.wstring() + L'"';
    if (shell_open(file.wstring(), nullptr) || shell_open(L"notepad.exe", quoted.c_str())) {
        return {};
    }
    return std::unexpected(system_error("cannot open " + utf8(file.wstring())));
}

Result<void> open_folder(const std::filesystem::path& folder) {
    const ComSession com;
    if (shell_open(folder.wstring(), nullptr)) {
        return {};
    }
    return std::unexpected(system_error("cannot open " + utf8(folder.wstring())));
}

}  // namespace hyrax::win32
