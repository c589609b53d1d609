// SPDX-License-Identifier: MIT
// What a system call says when it fails.
#pragma once

#include "daemon/core/result.h"

#include <cerrno>
#include <string>
#include <system_error>

namespace hyrax {

/// "<what>: <reason>", of errno.
inline std::unexpected<Error> system_failure(const std::string& what, int code = errno) {
    return failure(what + ": " + std::generic_category().message(code));
}

}  // namespace hyrax
