// SPDX-License-Identifier: MIT
// What config.json says of a plugin, before its manifest is known.
#pragma once

#include "daemon/core/script_value.h"

#include <optional>
#include <string>
#include <vector>

namespace hyrax {

struct GivenSetting {
    std::string key;
    ScriptValue value;
    std::string place{};  ///< "config.json:12:18"
    std::string found{};  ///< As the file writes it, for messages.

    /// Where it stands makes no difference.
    bool operator==(const GivenSetting& other) const {
        return key == other.key && value == other.value;
    }
};

struct PluginChoice {
    std::optional<bool> enabled{};
    std::vector<GivenSetting> settings{};
    bool operator==(const PluginChoice&) const = default;
};

}  // namespace hyrax
