// SPDX-License-Identifier: MIT
#include "daemon/win32/folder_watch.h"

#include "daemon/win32/process.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <system_error>
#include <utility>

namespace hyrax::win32 {

namespace {

constexpr Ticks look_again_after = 2 * ticks_per_second;

constexpr DWORD interesting = FILE_NOTIFY_CHANGE_FILE_NAME | FILE_NOTIFY_CHANGE_DIR_NAME |
                              FILE_NOTIFY_CHANGE_LAST_WRITE | FILE_NOTIFY_CHANGE_SIZE;

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

/// Far more than a profile has; keeps a link to a whole disk from opening all of it.
constexpr std::size_t most_folders = 200;

}  // namespace

struct FolderWatch::Watched {
    KernelObject handle;
    bool is_top = false;
    bool pending = false;
    OVERLAPPED overlapped{};
    alignas(DWORD) std::array<std::byte, 16U << 10U> records{};

    Watched(KernelObject opened, bool top) : handle(std::move(opened)), is_top(top) {}
    Watched(const Watched&) = delete;
    Watched& operator=(const Watched&) = delete;
    /// The system may write to the records until it says that it has stopped.
    ~Watched() {
        if (pending) {
            DWORD bytes = 0;
            ::CancelIoEx(handle.raw(), &overlapped);
            ::GetOverlappedResult(handle.raw(), &overlapped, &bytes, TRUE);
        }
    }

    void ask(HANDLE ready) {
        overlapped = {};
        overlapped.hEvent = ready;
        pending = ::ReadDirectoryChangesW(
                      handle.raw(),
                      records.data(),
                      static_cast<DWORD>(records.size()),
                      TRUE,
                      interesting,
                      nullptr,
                      &overlapped,
                      nullptr
                  ) != 0;
    }
};

FolderWatch::FolderWatch(std::filesystem::path folder, std::vector<std::wstring> ignored, Ticks now)
    : folder_(std::move(folder)),
      ignored_(std::move(ignored)),
      ready_(::CreateEventW(nullptr, TRUE, FALSE, nullptr)) {
    open();
    look_again_ = watched_.empty() ? now + look_again_after : never;
}

FolderWatch::~FolderWatch() = default;

Ticks FolderWatch::due() const {
    return std::min(changes_.due(), look_again_);
}

bool FolderWatch::check(Ticks now) {
    read_answers(now);
    if (now >= look_again_) {
        open();
        look_again_ = watched_.empty() ? now + look_again_after : never;
        if (!watched_.empty()) {
            changes_.hint(now);
        }
    }
    if (!changes_.take(now)) {
        return false;
    }
    // Under Wine 8 a folder that was removed, or replaced by a new one, leaves the old handle
    // silent. What changes in between is read by whoever is told now.
    close();
    open();
    look_again_ = watched_.empty() ? now + look_again_after : never;
    return true;
}

/// Windows watches all that is below a folder. Wine 8 does so only for folders that come later.
void FolderWatch::open() {
    add(folder_, true);
    if (watched_.empty() || !runs_under_wine()) {
        return;
    }
    std::error_code error;
    std::filesystem::recursive_directory_iterator entry(folder_, error);
    for (; !error && entry != std::filesystem::recursive_directory_iterator();
         entry.increment(error)) {
        if (is_ignored(entry->path().lexically_relative(folder_).native())) {
            entry.disable_recursion_pending();
        } else if (entry->is_directory(error) && watched_.size() < most_folders) {
            add(entry->path(), false);
        }
    }
}

void FolderWatch::add(const std::filesystem::path& folder, bool is_top) {
    KernelObject handle = owned_file(::CreateFileW(
        folder.c_str(),
        FILE_LIST_DIRECTORY,
        share_all,
        nullptr,
        OPEN_EXISTING,
        FILE_FLAG_BACKUP_SEMANTICS | FILE_FLAG_OVERLAPPED,
        nullptr
    ));
    if (handle) {
        watched_.push_back(std::make_unique<Watched>(std::move(handle), is_top));
        watched_.back()->ask(ready_.raw());
    }
}

void FolderWatch::close() {
    watched_.clear();
    ::ResetEvent(ready_.raw());
}

/// To ask again takes the event back, also that of an answer that has just come: so until a whole
/// round finds none.
void FolderWatch::read_answers(Ticks now) {
    bool found = true;
    while (found) {
        found = false;
        for (const std::unique_ptr<Watched>& watched : watched_) {
            if (watched->pending && HasOverlappedIoCompleted(&watched->overlapped)) {
                found = read_answer(*watched, now) || found;
            }
        }
    }
}

/// False when the folder is not watched any more: it is gone. Until our handle is closed, which the
/// hint leads to, nobody could make it anew.
bool FolderWatch::read_answer(Watched& watched, Ticks now) {
    DWORD bytes = 0;
    const bool ok =
        ::GetOverlappedResult(watched.handle.raw(), &watched.overlapped, &bytes, FALSE) != 0;
    watched.pending = false;
    const bool overflow = !ok && ::GetLastError() == ERROR_NOTIFY_ENUM_DIR;
    if (!ok && !overflow) {
        ::ResetEvent(ready_.raw());
        changes_.hint(now);
        return false;
    }
    if (overflow || concerns_us(watched, bytes)) {
        changes_.hint(now);
    }
    watched.ask(ready_.raw());
    if (!watched.pending) {
        changes_.hint(now);
    }
    return watched.pending;
}

bool FolderWatch::is_ignored(std::wstring_view path) const {
    return std::ranges::any_of(ignored_, [&](const std::wstring& name) {
        return same_name(name, first_part(path));
    });
}

/// No bytes: there were more changes than the records could hold.
bool FolderWatch::concerns_us(const Watched& watched, std::size_t bytes) const {
    constexpr std::size_t head_size = offsetof(FILE_NOTIFY_INFORMATION, FileName);
    bool concerns = bytes == 0 || !watched.is_top;
    std::size_t at = 0;
    while (!concerns && at + head_size < bytes) {
        FILE_NOTIFY_INFORMATION head;
        std::memcpy(&head, watched.records.data() + at, head_size);
        std::wstring path(head.FileNameLength / sizeof(wchar_t), L'\0');
        std::memcpy(path.data(), watched.records.data() + at + head_size, head.FileNameLength);
        concerns = !is_ignored(path);
        if (head.NextEntryOffset == 0) {
            break;
        }
        at += head.NextEntryOffset;
    }
    return concerns;
}

}  // namespace hyrax::win32
