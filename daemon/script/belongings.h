// SPDX-License-Identifier: MIT
// What the daemon keeps for a script: its store, its settings, its version.
#pragma once

#include "daemon/core/script_port.h"

#include <cstddef>
#include <string>
#include <vector>

namespace hyrax::script {

struct Belongings {
    explicit Belongings(const ScriptSource& source)
        : version(source.version),
          modules(source.modules),
          config(source.config),
          store(source.store),
          store_size(size_of(source.store)) {}

    std::string version;
    std::vector<ScriptModule> modules;
    Vec2 wind;  ///< As hyrax.wind left it.
    ScriptTable config;
    ScriptTable store;
    std::size_t store_size;  ///< [bytes]
    Ticks next_notice = 0;   ///< When hyrax.notify may be called again.
};

}  // namespace hyrax::script
