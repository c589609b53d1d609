// SPDX-License-Identifier: MIT
// The cases of hyrax.test: one runs at a time, and any error of the script meanwhile fails it.
#pragma once

#include "daemon/core/script_port.h"
#include "physics/ticks.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct lua_State;

namespace hyrax::script {

class TestCases {
public:
    explicit TestCases(bool enabled) : enabled_(enabled) {}

    /// Only then does the script have hyrax.test.
    bool enabled() const { return enabled_; }
    /// `function` is a reference that the owner understands.
    void add(std::string name, int function) { waiting_.push_back({std::move(name), function}); }
    std::size_t open() const { return waiting_.size() + (running_ ? 1U : 0U); }

    /// The function of the next case, which runs from now on; none while one runs.
    std::optional<int> begin_next(Ticks now);
    /// The coroutine in which the case runs.
    void runs_in(const lua_State* thread);
    bool is_running(const lua_State* thread) const {
        return running_ && running_->thread == thread;
    }
    /// False if none runs. The first problem of a case is the one that is told.
    bool fail(std::string_view problem);
    /// Ends the case that runs, if one does.
    std::optional<ScriptTest> end(std::string_view script, Ticks now);
    /// Ends the case that runs and all that wait, for the same reason.
    std::vector<ScriptTest> give_up(std::string_view script, Ticks now, std::string_view problem);

private:
    struct Case {
        std::string name;
        int function = 0;
    };
    struct Running {
        std::string name;
        const lua_State* thread = nullptr;
        Ticks since = 0;
        std::string problem;
    };

    bool enabled_;
    std::vector<Case> waiting_;
    std::optional<Running> running_;
};

}  // namespace hyrax::script
