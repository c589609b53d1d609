// SPDX-License-Identifier: MIT
// Windows of other programs from a file, for hyrax-headless.
#pragma once

#include "daemon/core/ledges.h"
#include "daemon/core/result.h"
#include "physics/ticks.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace hyrax {

/// All windows, the topmost first, from a moment on.
struct TimedWindows {
    Ticks time = 0;
    std::vector<DesktopWindow> windows;
    bool operator==(const TimedWindows&) const = default;
};

/// Lines `time,id,x,y,width,height[,word ...]`: seconds from 0 to 1e6, a whole number that names
/// the window, its frame [px], and any of the words active, hidden, overlay, bar and maximised. The
/// lines of one time, which may not go back, are all windows from then on, the topmost first; a
/// time alone means that there are none. Empty lines and those that begin with # do not count.
/// `file` names the text in messages.
[[nodiscard]] Result<std::vector<TimedWindows>> parse_windows(
    std::string_view text, std::string_view file
);

/// Reads and parses a file of at most 16 MiB.
[[nodiscard]] Result<std::vector<TimedWindows>> load_windows(const std::filesystem::path& path);

}  // namespace hyrax
