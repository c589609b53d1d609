// SPDX-License-Identifier: MIT
// Who runs this process.
#pragma once

#include "daemon/core/result.h"

#include <string>

namespace hyrax::win32 {

/// The user's security identifier as text: "S-1-5-21-...".
[[nodiscard]] Result<std::wstring> user_sid();

}  // namespace hyrax::win32
