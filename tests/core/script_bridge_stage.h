// SPDX-License-Identifier: MIT
// A bridge to scripts that a test plays.
#pragma once

#include "daemon/core/script_bridge.h"

#include <doctest/doctest.h>

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace hyrax {

// Remembers what came in and answers what the test wants.
struct Recorder {
    int runs = 0;
    ScriptWorld world;
    std::vector<ScriptEvent> events;
    ScriptOutput answer;
};

class RecordingHost : public ScriptHost {
public:
    explicit RecordingHost(Recorder& recorder) : recorder_(recorder) {}
    void load(std::vector<ScriptSource>) override {}
    ScriptOutput run(const ScriptWorld& world, std::span<const ScriptEvent> events) override {
        ++recorder_.runs;
        recorder_.world = world;
        recorder_.events.assign(events.begin(), events.end());
        ScriptOutput answer = recorder_.answer;
        recorder_.answer.commands.clear();
        return answer;
    }

private:
    Recorder& recorder_;
};

class BusyHost final : public RecordingHost {
public:
    using RecordingHost::RecordingHost;
    bool busy() const override { return is_busy; }
    std::optional<ScriptOutput> take_output() override {
        return std::exchange(output, std::nullopt);
    }

    bool is_busy = false;
    std::optional<ScriptOutput> output;
};

struct Stage {
    Stage()
        : engine({{"hyrax", {10, 10}}}, {}, 1), bridge(std::make_unique<RecordingHost>(recorder)) {
        engine.set_arena(Arena({{{0, 0, 800, 600}, {0, 0, 800, 600}, true, {}}}, FloorEdge::screen)
        );
        recorder.answer.listening = EventMask::all();
        bridge.load({{"test.lua", ""}});
    }
    void run(Ticks now = 0) { bridge.run(engine, {}, now); }

    Recorder recorder;
    Engine engine;
    ScriptBridge bridge;
};

inline constexpr PetKey key = script_made_key | 1U;

}  // namespace hyrax
