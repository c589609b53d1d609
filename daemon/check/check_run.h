// SPDX-License-Identifier: MIT
// A script among pets on one screen, on a clock of its own.
#pragma once

#include "daemon/core/engine.h"
#include "daemon/core/script_port.h"

#include <string>
#include <vector>

namespace hyrax {

/// What a script told in a run.
struct CheckRun {
    std::vector<ScriptLog> log;
    std::vector<ScriptTest> tests;
    std::size_t open_tests = 0;  ///< Cases that did not end in time.
};

/// Runs the script for so long, or until its cases have ended if it is tested. Now and then a pet
/// of the user's falls, is clicked and is thrown.
CheckRun run_script(ScriptSource source, std::vector<Kind> kinds, double seconds);

}  // namespace hyrax
