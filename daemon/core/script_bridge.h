// SPDX-License-Identifier: MIT
// Between the engine and the scripts: snapshots and events to them, their commands to the engine.
#pragma once

#include "daemon/core/engine.h"
#include "daemon/core/script_port.h"

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hyrax {

/// Finds out, just before a run, what some script may see and names in its text.
struct ScriptEyes {
    std::function<std::optional<Vec2>()> cursor{};  ///< Empty: not known.
    std::function<std::vector<Rect>()> windows{};   ///< At most ScriptBridge::most_windows.
};

/// When the daemon ends, by both clocks.
struct LastMoment {
    Ticks world = 0;
    Ticks machine = 0;
};

/// Without a host, or without a script, every call is free.
class ScriptBridge {
public:
    explicit ScriptBridge(std::unique_ptr<ScriptHost> host) : host_(std::move(host)) {}

    /// Commands that one run() applies; the others wait for the next frame, and scripts with them.
    static constexpr std::size_t most_commands = 1'000;
    /// Events that wait for scripts that are still busy. Above that, the oldest are dropped.
    static constexpr std::size_t most_events = 1'024;
    /// That scripts are told of.
    static constexpr std::size_t most_windows = 1'000;
    /// Pressed hotkeys that wait for scripts that are still busy.
    static constexpr std::size_t most_pressed = 16;

    /// Counts from the next load() on.
    void set_limits(const ScriptLimits& limits);
    /// These are to run from the next run() on, as ScriptHost::load() has it.
    void load(std::vector<ScriptSource> sources);
    /// The next load() takes every text for a new one, those that were ended too.
    void renew();
    /// Hands over the engine's events, runs what is due at `now` and applies the commands. Failures
    /// are logged, the first one of a frame and how many there were; a command for a pet that has
    /// gone meanwhile is dropped.
    void run(
        Engine& engine, const std::vector<Monitor>& monitors, Ticks now, const ScriptEyes& eyes = {}
    );
    /// The last run: scripts hear that the daemon ends, unless they do not come to it within the
    /// patience. What they answer within it is carried out. The one call that waits.
    void end(
        Engine& engine,
        const std::vector<Monitor>& monitors,
        const LastMoment& at,
        std::chrono::milliseconds patience
    );
    /// While calm, no script sets a pet in motion that stands on the ground.
    void set_calm(bool calm) { calm_ = calm; }
    /// Scripts run on, but what moves or spawns pets is refused, with a warning for each verb.
    void set_quiet(bool quiet);
    bool quiet() const { return quiet_; }
    /// The latest error of each script that it has not been replaced since, by its name.
    const std::map<std::string, std::string>& errors() const { return errors_; }
    /// Of this script; empty: none.
    std::string error_of(const std::string& script) const {
        const auto found = errors_.find(script);
        return found == errors_.end() ? std::string() : found->second;
    }
    /// As far as it has been heard; all nothing for a script that does not run.
    ScriptUse use_of(const std::string& script) const {
        const auto found = uses_.find(script);
        return found == uses_.end() ? ScriptUse{} : found->second;
    }
    /// When run() has something to do, apart from events.
    Ticks next_wake() const;

    /// Looks after scripts in a process of their own. `now`: the machine's clock.
    void watch(Ticks now);
    /// When watch() wants to be called, at the latest [machine's clock].
    Ticks watch_due() const { return host_ ? host_->watch_due() : never; }

    /// Told in the next run, which is due at once. Scripts that are busy for long miss some.
    void tell(PressedHotkey hotkey);
    /// True once after nothing was left of the scripts' state: what they have asked of the desktop
    /// before the next take_wishes() is void.
    bool take_loss() { return std::exchange(lost_, false); }
    /// Has a script carry out a text in the next run, which is due at once. The number comes back
    /// in take_evaluated(), unless no script runs any more.
    std::uint64_t evaluate(std::string script, std::string text);
    /// Those that scripts have not been told of yet.
    std::size_t waiting_evaluations() const { return evaluations_.size(); }
    std::vector<Evaluated> take_evaluated() { return std::exchange(evaluated_, {}); }
    /// Those of the loaded that do not run: ended by their limits, or never loaded well.
    std::vector<std::string> ended() const;
    /// Commands of scripts that are not for the engine (Store, Notify, Hotkey), since the last
    /// call.
    std::vector<ScriptCommand> take_wishes() { return std::exchange(wishes_, {}); }
    /// Names of scripts that were killed too often to run again, since the last call.
    std::vector<std::string> take_given_up() { return std::exchange(given_up_, {}); }
    /// Removes the pets of somebody who is no longer loaded, and those that it still asks for.
    void retire(Engine& engine, const std::string& owner);

private:
    using Clock = std::chrono::steady_clock;

    PetKey key_of(PetId id) const;
    PetId id_of(PetKey key) const;
    ScriptWorld snapshot(const Engine& engine, const std::vector<Monitor>& monitors, Ticks now);
    bool must_stay(const Pet& pet) const;
    void queue_events(Engine& engine);
    std::vector<ScriptEvent> take_queue();
    bool hear_out(Engine& engine, Ticks machine, Clock::time_point until);
    void forget_hotkeys(std::vector<ScriptCommand>& answered);
    void use(Engine& engine, ScriptOutput output);
    void apply_commands(Engine& engine);
    Result<void> apply(Engine& engine, const ScriptCommand& command);
    bool refuses(const ScriptCommand& command);
    void blow(Engine& engine, const std::string& script, Vec2 wind);
    void forget_removed(const Engine& engine);

    std::unique_ptr<ScriptHost> host_;
    bool loaded_ = false;     // Somebody runs, or has not been told of the end yet.
    bool unloading_ = false;  // Nobody is to run any more.
    bool calm_ = false;
    bool quiet_ = false;
    Ticks next_wake_ = never;
    std::set<std::string_view> refused_;  // Verbs that have been told of.
    std::map<std::string, std::string> errors_;
    std::map<std::string, ScriptUse> uses_;      // By script.
    std::map<std::string, ScriptSource> texts_;  // By name, as loaded.
    std::set<std::string> retired_;
    std::vector<std::string> given_up_;
    std::map<std::string, Vec2> winds_;  // By script.
    std::deque<ScriptEvent> events_;
    std::size_t dropped_events_ = 0;
    std::deque<ScriptCommand> commands_;
    bool watch_cursor_ = false;  // Some script may see it and names it.
    bool watch_windows_ = false;
    bool lost_ = false;
    std::vector<PressedHotkey> pressed_hotkeys_;
    std::vector<ScriptCommand> wishes_;
    std::vector<Evaluation> evaluations_;
    std::vector<Evaluated> evaluated_;
    std::uint64_t last_evaluation_ = 0;
    // Pets that scripts spawned, both ways; all others have keys made from their ids.
    std::unordered_map<PetKey, PetId> made_;
    std::unordered_map<PetKey, PetKey> made_key_of_;
};

}  // namespace hyrax
