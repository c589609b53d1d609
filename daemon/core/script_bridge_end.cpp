// SPDX-License-Identifier: MIT
// The last run of the scripts, the only one that is waited for.
#include "daemon/core/script_bridge.h"

#include <utility>

namespace hyrax {

void ScriptBridge::end(
    Engine& engine,
    const std::vector<Monitor>& monitors,
    const LastMoment& at,
    std::chrono::milliseconds patience
) {
    const Clock::time_point until = Clock::now() + patience;
    if (loaded_ && hear_out(engine, at.machine, until)) {
        queue_events(engine);
        ScriptWorld world = snapshot(engine, monitors, at.world);
        world.ending = true;
        use(engine, host_->run(world, take_queue()));
        hear_out(engine, at.machine, until);
    }
    while (!commands_.empty()) {
        apply_commands(engine);
    }
}

// Until scripts have answered what they were sent last. False: they have not.
bool ScriptBridge::hear_out(Engine& engine, Ticks machine, Clock::time_point until) {
    while (true) {
        host_->watch(machine);
        if (std::optional<ScriptOutput> output = host_->take_output()) {
            use(engine, *std::move(output));
        }
        if (!host_->busy()) {
            return true;
        }
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now());
        if (left.count() <= 0 || !host_->wait(left)) {
            return false;
        }
    }
}

}  // namespace hyrax
