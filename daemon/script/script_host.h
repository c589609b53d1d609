// SPDX-License-Identifier: MIT
// Makes the host that runs Lua scripts; everything else goes through ScriptHost's plain data.
#pragma once

#include "daemon/core/script_limits.h"
#include "daemon/core/script_port.h"

#include <memory>

namespace hyrax {

/// Runs the scripts in this process and on the calling thread, deterministically: the same
/// sources, worlds and events give the same outputs. run() must not be called from within run().
[[nodiscard]] std::unique_ptr<ScriptHost> make_script_host(const ScriptLimits& limits = {});

}  // namespace hyrax
