// SPDX-License-Identifier: MIT
// Monitors from the command line.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/core/result.h"

#include <string_view>
#include <vector>

namespace hyrax {

/// "1920x1080+0+0,3200x1800-3200-200@1.5": width, height and the top-left corner of each monitor
/// [px], and its scale, which is 1 where none is given. The first one is the primary; sides from 1
/// to 32768, corners within +-100000, scales from 0.5 to 5. Work areas fill their monitors. An
/// empty text means no monitor.
[[nodiscard]] Result<std::vector<Monitor>> parse_monitors(std::string_view text);

}  // namespace hyrax
