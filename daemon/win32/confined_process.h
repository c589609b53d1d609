// SPDX-License-Identifier: MIT
// Starts a program that may do next to nothing.
#pragma once

#include "daemon/core/result.h"
#include "daemon/win32/handle.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace hyrax::win32 {

struct ConfinedProcess {
    KernelObject job;  ///< Closing it ends the process.
    KernelObject process;
};

struct ConfinementPlan {
    std::filesystem::path program;
    std::wstring arguments;       ///< Without the program.
    std::span<HANDLE> inherited;  ///< Must be inheritable; the process gets no others.
    std::size_t most_memory = 0;  ///< [bytes]
};

/// The process has not run an instruction before it is inside its job.
[[nodiscard]] Result<ConfinedProcess> start_confined(const ConfinementPlan& plan);

}  // namespace hyrax::win32
