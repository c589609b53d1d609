// SPDX-License-Identifier: MIT
// The texts of a developer that a script is carrying out, each in a coroutine of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

struct lua_State;

namespace hyrax::script {

class Evaluations {
public:
    struct Open {
        std::uint64_t id = 0;
        const lua_State* thread = nullptr;  ///< None until it has one.
        std::string printed{};
        bool has_waited = false;
    };

    void begin(std::uint64_t id) { open_.push_back({.id = id}); }
    /// The coroutine in which the one that has just begun runs.
    void runs_in(const lua_State* thread) {
        if (!open_.empty() && open_.back().thread == nullptr) {
            open_.back().thread = thread;
        }
    }
    /// The one that runs in this coroutine, which is no longer open.
    std::optional<Open> take(const lua_State* thread) {
        for (auto each = open_.begin(); each != open_.end(); ++each) {
            if (each->thread == thread) {
                Open taken = std::move(*each);
                open_.erase(each);
                return taken;
            }
        }
        return std::nullopt;
    }
    /// Null once it has been taken.
    Open* find(std::uint64_t id) {
        for (Open& each : open_) {
            if (each.id == id) {
                return &each;
            }
        }
        return nullptr;
    }
    std::vector<Open> take_all() { return std::exchange(open_, {}); }

private:
    std::vector<Open> open_;
};

}  // namespace hyrax::script
