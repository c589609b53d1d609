// SPDX-License-Identifier: MIT
// The control pipe's name, and who may open it.
#pragma once

#include "daemon/core/result.h"
#include "daemon/win32/handle.h"

#include <string>

namespace hyrax::win32 {

/// `\\.\pipe\<instance name>-s<session>`: a daemon in another session is another one.
[[nodiscard]] Result<std::wstring> pipe_name(const std::wstring& instance);

/// This user is the owner and the only one who may open; programs of low integrity, such as a
/// browser's sandbox, may not write.
[[nodiscard]] Result<LocalMemory> pipe_security();

/// Whether the object belongs to this user. For a pipe: whether this user made it.
[[nodiscard]] Result<void> check_owner(HANDLE object);

}  // namespace hyrax::win32
