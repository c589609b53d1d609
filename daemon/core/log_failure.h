// SPDX-License-Identifier: MIT
// For failures that are told and then leave things as they were.
#pragma once

#include "daemon/core/result.h"

#include <spdlog/spdlog.h>

namespace hyrax {

/// A warning in the log, if it failed.
inline void log_failure(const Result<void>& done) {
    if (!done) {
        spdlog::warn("{}", done.error().message);
    }
}

}  // namespace hyrax
