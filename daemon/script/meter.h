// SPDX-License-Identifier: MIT
// What one script uses: memory, and work in units that are the same on every machine (one for a VM
// instruction, more for library calls and allocations). Ends a script that uses too much.
#pragma once

#include "daemon/script/call_trace.h"
#include "daemon/script/script_host.h"

#include <lua.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace hyrax::script {

/// Why and where a script was ended.
struct Verdict {
    std::string reason;
    CallTrace trace;
};

class Meter {
public:
    explicit Meter(const ScriptLimits& limits) : limits_(limits) {}

    /// A new call by the host: so much work, so much processor time.
    void begin(std::int64_t units, std::chrono::nanoseconds time);

    /// For work that no instruction count sees. Raises when the budget is spent.
    void charge(lua_State* lua, std::int64_t units) {
        units_ -= units;
        check(lua);
    }
    /// Raises when the budget is spent. To be called after every call that may have caught an
    /// error.
    void check(lua_State* lua) {
        if (killed_ || units_ <= 0) {
            stop(lua);
        }
    }
    /// The script has been ended for good: none of its code may run again.
    bool killed() const { return killed_; }
    bool spent() const { return units_ <= 0; }
    /// Ends the script for its spent budget, without raising.
    void condemn(lua_State* lua) { condemn(lua, budget_spent()); }
    const Verdict& verdict() const { return verdict_; }
    std::size_t heap() const { return heap_; }
    /// Units that all calls so far have used.
    std::uint64_t used() const { return used_ + static_cast<std::uint64_t>(budget_ - units_); }

    /// Makes this coroutine, and those that it creates, count their instructions.
    static void watch(lua_State* lua);
    /// A lua_Alloc; the user data is the Meter.
    static void* allocate(void* meter, void* block, std::size_t old_size, std::size_t new_size);

    /// Instructions between two looks at the budget.
    static constexpr int period = 200;

private:
    static void on_count(lua_State* lua, lua_Debug* call);
    [[noreturn]] void stop(lua_State* lua);
    void condemn(lua_State* lua, std::string reason);
    void look_at_clock(lua_State* lua);
    bool refuses(bool is_new, std::size_t kind, std::size_t old_size, std::size_t new_size);
    std::string budget_spent() const;
    std::chrono::nanoseconds processor_time() const;

    const ScriptLimits& limits_;
    std::uint64_t used_ = 0;  // By the calls before this one.
    // Of this call.
    std::int64_t budget_ = INT64_MAX;
    std::int64_t units_ = INT64_MAX;
    std::chrono::nanoseconds time_{};
    std::optional<std::chrono::nanoseconds> half_time_;  // Processor time at about the half of it.
    std::chrono::steady_clock::time_point deadline_ = std::chrono::steady_clock::time_point::max();
    std::size_t heap_ = 0;
    bool killed_ = false;
    Verdict verdict_;
};

}  // namespace hyrax::script
