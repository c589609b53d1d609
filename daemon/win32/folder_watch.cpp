// SPDX-License-Identifier: MIT
#include "daemon/win32/folder_watch.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace hyrax::win32 {

namespace {

constexpr Ticks look_again_after = 2 * ticks_per_second;

constexpr DWORD interesting = FILE_NOTIFY_CHANGE_FILE_NAME | FILE_NOTIFY_CHANGE_DIR_NAME
                              | FILE_NOTIFY_CHANGE_LAST_WRITE | FILE_NOTIFY_CHANGE_SIZE;

/// Without FILE_SHARE_DELETE nobody could rename or delete the folder while the daemon runs.
constexpr DWORD share_all = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

std::wstring_view first_part(std::wstring_view path) {
    return path.substr(0, path.find_first_of(L"\\/"));
}

bool same_name(std::wstring_view a, std::wstring_view b) {
    return ::CompareStringOrdinal(
               a.data(), static_cast<int>(a.size()), b.data(), static_cast<int>(b.size()), TRUE
           ) == CSTR_EQUAL;
}

}  // namespace

struct FolderWatch::Request {
    OVERLAPPED overlapped{};
    alignas(DWORD) std::array<std::byte, 16U << 10U> records{};
    bool pending = false;
};

FolderWatch::FolderWatch(std::filesystem::path folder, std::vector<std::wstring> ignored, Ticks now)
    : folder_(std::move(folder)),
      ignored_(std::move(ignored)),
      ready_(::CreateEventW(nullptr, TRUE, FALSE, nullptr)),
      request_(std::make_unique<Request>()) {
    open(now);
}

FolderWatch::~FolderWatch() {
    close(0);
}

Ticks FolderWatch::due() const {
    return std::min(changes_.due(), look_again_);
}

bool FolderWatch::check(Ticks now) {
    if (request_->pending && ::WaitForSingleObject(ready_.raw(), 0) == WAIT_OBJECT_0) {
        read_answer(now);
    }
    if (now >= look_again_) {
        open(now);
        if (handle_) {
            changes_.hint(now);
        }
    }
    if (!changes_.take(now)) {
        return false;
    }
    // Under Wine 8 a folder that was removed, or replaced by a new one, leaves the old handle
    // silent. What changed in between is read by whoever is told now.
    close(now);
    open(now);
    return true;
}

void FolderWatch::open(Ticks now) {
    look_again_ = never;
    handle_ = owned_file(::CreateFileW(
        folder_.c_str(), FILE_LIST_DIRECTORY, share_all, nullptr, OPEN_EXISTING,
        FILE_FLAG_BACKUP_SEMANTICS | FILE_FLAG_OVERLAPPED, nullptr
    ));
    if (handle_) {
        ask(now);
    } else {
        look_again_ = now + look_again_after;
    }
}

/// The system may write to the request until it says that it has stopped.
void FolderWatch::close(Ticks now) {
    if (request_->pending) {
        DWORD bytes = 0;
        ::CancelIoEx(handle_.raw(), &request_->overlapped);
        ::GetOverlappedResult(handle_.raw(), &request_->overlapped, &bytes, TRUE);
        request_->pending = false;
    }
    handle_.reset();
    ::ResetEvent(ready_.raw());
    look_again_ = now + look_again_after;
}

void FolderWatch::ask(Ticks now) {
    request_->overlapped = {};
    request_->overlapped.hEvent = ready_.raw();
    request_->pending = ::ReadDirectoryChangesW(
                            handle_.raw(), request_->records.data(),
                            static_cast<DWORD>(request_->records.size()), TRUE, interesting, nullptr,
                            &request_->overlapped, nullptr
                        )
                        != 0;
    if (!request_->pending) {
        close(now);  // The folder is gone; while our handle is open, nobody could make it anew.
        changes_.hint(now);
    }
}

void FolderWatch::read_answer(Ticks now) {
    DWORD bytes = 0;
    const bool ok =
        ::GetOverlappedResult(handle_.raw(), &request_->overlapped, &bytes, FALSE) != 0;
    request_->pending = false;
    if (!ok && ::GetLastError() != ERROR_NOTIFY_ENUM_DIR) {
        close(now);
        changes_.hint(now);
        return;
    }
    if (!ok || concerns_us(bytes)) {
        changes_.hint(now);
    }
    ask(now);
}

/// No bytes: there were more changes than the records could hold.
bool FolderWatch::concerns_us(std::size_t bytes) const {
    bool concerns = bytes == 0;
    std::size_t at = 0;
    while (at + offsetof(FILE_NOTIFY_INFORMATION, FileName) < bytes) {
        FILE_NOTIFY_INFORMATION head;
        std::memcpy(&head, request_->records.data() + at, offsetof(FILE_NOTIFY_INFORMATION, FileName));
        std::wstring path(head.FileNameLength / sizeof(wchar_t), L'\0');
        std::memcpy(
            path.data(), request_->records.data() + at + offsetof(FILE_NOTIFY_INFORMATION, FileName),
            path.size() * sizeof(wchar_t)
        );
        concerns = concerns || std::ranges::none_of(ignored_, [&](const std::wstring& name) {
            return same_name(name, first_part(path));
        });
        if (head.NextEntryOffset == 0) {
            break;
        }
        at += head.NextEntryOffset;
    }
    return concerns;
}

}  // namespace hyrax::win32
