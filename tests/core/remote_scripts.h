// SPDX-License-Identifier: MIT
// A RemoteScriptHost whose process a test plays.
#pragma once

#include "daemon/core/remote_script_host.h"
#include "tests/core/fake_script_channel.h"

#include <doctest/doctest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hyrax {

inline constexpr Ticks ms = ticks_per_ms;

struct Remote {
    FakeProcess process;
    RemoteScriptHost host{std::make_unique<FakeScriptChannel>(process)};
    Ticks now = 0;

    // As the daemon does in a frame; empty unless an output came.
    std::optional<ScriptOutput> frame(std::vector<ScriptEvent> events = {}, Ticks later = 10 * ms) {
        now += later;
        host.watch(now);
        std::optional<ScriptOutput> output = host.take_output();
        if (!host.busy()) {
            const ScriptOutput at_once = host.run({.now = now, .pets = {}, .monitors = {}}, events);
            if (!at_once.log.empty()) {
                output = at_once;
            }
        }
        return output;
    }
    std::vector<std::string> loaded() const {
        std::vector<std::string> names;
        for (const ScriptSource& source : process.heard_of<ScriptSource>()) {
            names.push_back(source.name);
        }
        return names;
    }
    // Hangs in the script at this place, and is found out.
    std::string hang(std::uint32_t place) {
        process.pulse.enter(place);
        frame();
        *process.used += 240 * ms;
        CHECK_FALSE(frame());
        *process.used += 20 * ms;
        const auto output = frame();
        REQUIRE(output);
        REQUIRE_FALSE(output->log.empty());
        given_up = output->given_up;
        return output->log.front().text;
    }

    std::vector<std::string> given_up;  // By the last hang().
};

inline const std::vector<ScriptSource> three{{"a.lua", "a"}, {"b.lua", "b"}, {"c.lua", "c"}};
using Names = std::vector<std::string>;

}  // namespace hyrax
