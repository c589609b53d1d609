// SPDX-License-Identifier: MIT
#pragma once

#include "daemon/core/profile.h"
#include "tests/support/temporary_folder.h"

namespace hyrax {

/// With user/ and shipped/ below the folder.
inline Profile profile_in(const TemporaryFolder& folder) {
    return {
        .config = folder.path() / "user" / "config.json",
        .user = folder.path() / "user",
        .shipped = folder.path() / "shipped",
        .more_scripts = {},
    };
}

}  // namespace hyrax
