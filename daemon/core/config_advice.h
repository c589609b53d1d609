// SPDX-License-Identifier: MIT
// What a user who tunes should know about settings that are allowed but unusual.
#pragma once

#include "daemon/core/engine.h"

#include <string>
#include <vector>

namespace hyrax {

/// One line for each surprise that a stiff or extreme law has in store, naming the key and what
/// will happen; none for ordinary settings. `fps`: frames a second.
std::vector<std::string> advice_on(const EngineSettings& settings, double fps);

}  // namespace hyrax
