// SPDX-License-Identifier: MIT
// The life of a script host's process: reads what the daemon sends, runs scripts, answers.
#pragma once

#include "daemon/core/script_limits.h"
#include "daemon/core/script_link.h"

namespace hyrax {

/// Until the daemon is gone; returns one of host_exit_*. `fixed` are the limits of this process
/// that the daemon does not send: its clock and its pulse.
[[nodiscard]] int serve_scripts(ScriptLink& link, const ScriptLimits& fixed);

}  // namespace hyrax
