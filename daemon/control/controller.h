// SPDX-License-Identifier: MIT
// The daemon's ear for the control channel: the text of a request in, the text of an answer out.
#pragma once

#include "daemon/control/save_file.h"
#include "daemon/core/control_port.h"

#include <memory>

namespace hyrax {

/// `{"ok": true, "result": {...}}` or `{"ok": false, "error": {"code": "...", "message": "..."}}`,
/// within the bounds of a message, whatever the request.
[[nodiscard]] std::unique_ptr<ControlPort> make_controller(SaveFile save);

}  // namespace hyrax
