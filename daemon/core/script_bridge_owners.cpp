// SPDX-License-Identifier: MIT
// What scripts leave in the world beside commands for single pets: who belonged to them, and wind.
#include "daemon/core/config.h"
#include "daemon/core/log_failure.h"
#include "daemon/core/script_bridge.h"

#include <spdlog/spdlog.h>

#include <vector>

namespace hyrax {

void ScriptBridge::retire(Engine& engine, const std::string& owner) {
    retired_.insert(owner);
    std::vector<PetId> pets;
    engine.for_each([&](PetId id, const Pet& pet) {
        if (pet.owner == owner) {
            pets.push_back(id);
        }
    });
    for (const PetId id : pets) {
        log_failure(engine.remove(id));
    }
}

// What several scripts blow adds up.
void ScriptBridge::blow(Engine& engine, const std::string& script, Vec2 wind) {
    if (wind == Vec2{}) {
        winds_.erase(script);
    } else {
        winds_[script] = wind;
    }
    Vec2 sum;
    for (const auto& [name, share] : winds_) {
        sum = sum + share;
    }
    const Integrator before = engine.integrator();
    if (const Result<void> done = engine.set_wind(sum); !done) {
        spdlog::warn("{}: {}", script, done.error().message);
    }
    if (engine.integrator() != before) {
        const std::string_view so = winds_.empty() ? "the wind is over" : "the wind blows";
        spdlog::info("{}: {} moves the pets", so, name_of(engine.integrator()));
    }
}

}  // namespace hyrax
