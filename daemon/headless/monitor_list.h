// SPDX-License-Identifier: MIT
// Monitors from the command line.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/core/result.h"

#include <string_view>
#include <vector>

namespace hyrax {

/// "1920x1080+0+0,1600x900-1600-200": width, height and the top-left corner of each monitor [px].
/// The first one is the primary; sides from 1 to 32768, corners within +-100000. Work areas fill
/// their monitors. An empty text means no monitor.
[[nodiscard]] Result<std::vector<Monitor>> parse_monitors(std::string_view text);

}  // namespace hyrax
