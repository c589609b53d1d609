// SPDX-License-Identifier: MIT
// Tells that something in a folder has changed; what, its user finds out.
#pragma once

#include "daemon/win32/debounce.h"
#include "daemon/win32/handle.h"
#include "physics/ticks.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax::win32 {

/// Watches a folder and all below it. Survives that the folder goes and comes back: while it is
/// missing, looks for it every two seconds.
class FolderWatch {
public:
    /// Changes below the `ignored` names at the top of the folder (logs, for one) do not count.
    FolderWatch(std::filesystem::path folder, std::vector<std::wstring> ignored, Ticks now);
    ~FolderWatch();
    FolderWatch(const FolderWatch&) = delete;
    FolderWatch& operator=(const FolderWatch&) = delete;

    /// Signalled when check() has something to read.
    HANDLE event() const { return ready_.raw(); }
    /// When check() is worth calling though nothing is signalled.
    Ticks due() const;
    /// True once after a burst of changes has ended, or when the folder came back.
    bool check(Ticks now);

private:
    struct Watched;  ///< A folder's handle, and what the system writes to while it watches.

    void open();
    void close();
    void add(const std::filesystem::path& folder, bool is_top);
    void read_answers(Ticks now);
    bool read_answer(Watched& watched, Ticks now);
    bool concerns_us(const Watched& watched, std::size_t bytes) const;
    bool is_ignored(std::wstring_view path) const;

    std::filesystem::path folder_;
    std::vector<std::wstring> ignored_;
    KernelObject ready_;
    std::vector<std::unique_ptr<Watched>> watched_;  ///< The folder itself first.
    Debounce changes_{200 * ticks_per_ms, 2 * ticks_per_second};
    Ticks look_again_ = never;
};

}  // namespace hyrax::win32
