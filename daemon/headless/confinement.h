// SPDX-License-Identifier: MIT
// Shuts this process in: memory and processor time is all that is left to it.
#pragma once

#include "daemon/core/result.h"

#include <cstddef>

namespace hyrax {

struct Cage {
    int wire = -1;  ///< The one descriptor that may still be read and written.
    std::size_t more_memory = std::size_t{1} << 30U;  ///< Above what is mapped now [bytes].
};

/// For good: no file, socket, process, thread or program can be opened, started or signalled any
/// more (EPERM), no memory made executable, no dump written. One thread.
[[nodiscard]] Result<void> confine(const Cage& cage);

}  // namespace hyrax
