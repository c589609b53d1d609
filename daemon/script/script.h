// SPDX-License-Identifier: MIT
// One script: its Lua state and everything that belongs to it. The host drives it from above, the
// functions of the API (api_*.cpp) and of the sandbox find it from their lua_State.
#pragma once

#include "daemon/script/belongings.h"
#include "daemon/script/evaluations.h"
#include "daemon/script/journal.h"
#include "daemon/script/meter.h"
#include "daemon/script/schedule.h"
#include "daemon/script/script_host.h"
#include "daemon/script/test_cases.h"
#include "daemon/script/world_view.h"

#include <lua.h>

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax::script {

/// What all scripts share during one run.
struct Run {
    Snapshot snapshot;
    ScriptOutput& output;
    std::uint64_t& last_made_key;
};

/// What stands on top of the stack of a coroutine that ended with this status, an error.
std::string error_text(lua_State* thread, int status);

class Script {
public:
    /// The text of the source is not kept.
    Script(const ScriptSource& source, const ScriptLimits& limits);
    Script(const Script&) = delete;
    Script& operator=(const Script&) = delete;
    ~Script();

    /// The script that a coroutine belongs to.
    static Script& of(lua_State* lua) { return **static_cast<Script**>(lua_getextraspace(lua)); }

    // --- for the host: script_run.cpp ---

    /// Opens a run. Everything below happens inside one.
    void begin(Run& run);
    /// False if it failed: then nothing of the script is left but its journal and its belongings.
    [[nodiscard]] bool run_main_chunk(const ScriptSource& source);
    void ready();
    void deliver(const ScriptEvent& event);
    void change_setting(const std::string& key, const ScriptValue& value);
    void press_hotkey(std::uint64_t id);
    void evaluate(const Evaluation& wanted);
    /// Timers, waits and ticks up to the run's time.
    void run_due();
    void end();
    /// The last that it hears; nothing of it runs afterwards. `reason`: "reload", "disable" or
    /// "exit".
    void unload(const char* reason);
    /// Its pets leave.
    void remove_pets();
    /// False once it was ended or paused: then it neither runs nor listens.
    bool active() const { return lua_ != nullptr && !paused_ && !meter.killed(); }
    /// Ended by its limits or never loaded: for good.
    bool ended() const { return lua_ == nullptr || meter.killed(); }
    EventMask listening() const { return active() ? schedule.listening() : EventMask{}; }
    ScriptUse use() const {
        return {name(), meter.used(), meter.heap(), journal.errors(), listening()};
    }
    Ticks next_wake() const { return active() ? schedule.next_wake() : never; }

    // --- for the functions that the script calls ---

    const ScriptLimits limits;
    Meter meter;
    Journal journal;
    WorldView view;
    Schedule schedule;
    Belongings belongings;
    TestCases tests;

    const std::string& name() const { return journal.script(); }
    Ticks now() const { return view.world().now; }
    /// Seconds since the main chunk ran.
    double seconds() const { return to_seconds(now() - loaded_at_); }
    PetKey make_key() { return script_made_key | ++run_->last_made_key; }
    bool may(std::string_view permission) const;
    /// Raises when the run's limit of commands is reached.
    void command(lua_State* lua, ScriptCommand command);
    /// A double in [0, 1) from the script's seed.
    double random_unit();

    /// Starts the function and its arguments on top of the stack in a coroutine of their own, which
    /// runs until it ends or waits. Its errors are reported here, not raised.
    void start(lua_State* lua, int arguments);
    /// Makes the calling coroutine wait: the result is to be returned from the C function.
    int park(lua_State* lua, Waiter waiter);
    /// Puts a reference to the value on top of the stack into the registry and pops it.
    int keep(lua_State* lua);
    void release(int reference);

    // --- for coroutine.*: sandbox_coroutine.cpp ---

    /// True if a wait reached the resumer `lua` of the coroutine that just yielded.
    bool parked() const { return parked_; }
    /// Gives up a wait that cannot pass through `lua`.
    void unpark();
    /// True for coroutines that wait in hyrax.wait, or for one that does.
    bool is_waiting(const lua_State* thread) const;
    /// `thread` waits for a coroutine that it resumed.
    void waits_inside(lua_State* thread, bool waits);
    bool is_host_thread(const lua_State* thread) const { return thread == running_.lua; }

private:
    // A coroutine of the script's that waits because one that it resumed does.
    struct InnerWait {
        const lua_State* thread = nullptr;
        const lua_State* host_thread = nullptr;  // Which waits for both.
    };

    void protect(void (*body)(lua_State*, void*), void* data);
    template <std::invocable<lua_State*> Body>
    void protect(Body body) {
        protect([](lua_State* lua, void* data) { (*static_cast<Body*>(data))(lua); }, &body);
    }
    template <std::invocable<lua_State*> PushArguments>
    void call(int function, PushArguments push);
    template <std::invocable<lua_State*> PushArguments>
    void wake(const Waiter& waiter, PushArguments push);
    // Calls push(lua, subject) for the arguments of each handler; `subject` is the pet that a
    // handler is about, or 0.
    template <typename PushArguments>
    void fire(Topic topic, PetKey first, PetKey second, PushArguments push);
    std::vector<std::uint64_t> waiters_for(Topic topic, const ScriptEvent& event) const;
    void drop_hotkeys();
    void end_wind();
    void run_tests();
    void end_test();
    void give_up_tests(const char* problem);
    bool end_evaluation(lua_State* thread, int status);
    void give_up_evaluations(const std::string& problem);
    void resume(HostThread thread, lua_State* from, int arguments);
    void report(lua_State* thread, int status);
    void end_waits_for_gone_pets();
    void forget_gone_pets();
    void close();

    lua_State* lua_ = nullptr;
    Run* run_ = nullptr;
    HostThread running_;  ///< Innermost coroutine of the host that is running.
    bool parked_ = false;
    bool paused_ = false;
    bool failed_ = false;  ///< A call since the main chunk began has raised an error.
    bool unloading_ = false;
    Evaluations evaluations_;
    std::vector<InnerWait> waiting_inside_;
    std::size_t commands_ = 0;
    Ticks loaded_at_ = 0;
    std::vector<std::string> permissions_;
    std::uint64_t random_;
};

}  // namespace hyrax::script
