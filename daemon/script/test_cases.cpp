// SPDX-License-Identifier: MIT
#include "daemon/script/test_cases.h"

#include <utility>

namespace hyrax::script {

std::optional<int> TestCases::begin_next(Ticks now) {
    if (running_ || waiting_.empty()) {
        return std::nullopt;
    }
    Case next = std::move(waiting_.front());
    waiting_.erase(waiting_.begin());
    running_ = Running{std::move(next.name), nullptr, now, {}};
    return next.function;
}

void TestCases::runs_in(const lua_State* thread) {
    if (running_ && running_->thread == nullptr) {
        running_->thread = thread;
    }
}

bool TestCases::fail(std::string_view problem) {
    if (running_ && running_->problem.empty()) {
        running_->problem = problem;
    }
    return running_.has_value();
}

std::optional<ScriptTest> TestCases::end(std::string_view script, Ticks now) {
    if (!running_) {
        return std::nullopt;
    }
    const Running ended = *std::exchange(running_, std::nullopt);
    return ScriptTest{
        std::string(script), ended.name, ended.problem, to_seconds(now - ended.since)
    };
}

std::vector<ScriptTest> TestCases::give_up(
    std::string_view script, Ticks now, std::string_view problem
) {
    std::vector<ScriptTest> ended;
    static_cast<void>(fail(problem));
    if (auto running = end(script, now)) {
        ended.push_back(*std::move(running));
    }
    for (Case& left : std::exchange(waiting_, {})) {
        ended.push_back({std::string(script), std::move(left.name), std::string(problem), 0.0});
    }
    return ended;
}

}  // namespace hyrax::script
