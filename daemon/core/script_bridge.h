// SPDX-License-Identifier: MIT
// Between the engine and the scripts: snapshots and events to them, their commands to the engine.
#pragma once

#include "daemon/core/engine.h"
#include "daemon/core/script_port.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hyrax {

/// Without a host, or without a script, every call is free.
class ScriptBridge {
public:
    explicit ScriptBridge(std::unique_ptr<ScriptHost> host) : host_(std::move(host)) {}

    /// Replaces all scripts; they start with the next run().
    void load(std::vector<ScriptSource> sources);
    /// Hands over the engine's events, runs what is due at `now` and applies the commands. A
    /// command that fails is logged; one for a pet that has gone meanwhile is dropped.
    void run(Engine& engine, const std::vector<Monitor>& monitors, Ticks now);
    /// The last run: scripts hear that the daemon ends.
    void end(Engine& engine, const std::vector<Monitor>& monitors, Ticks now);
    /// When run() has something to do, apart from events.
    Ticks next_wake() const { return next_wake_; }
    /// True if a loaded script has this permission: for nobody else anything has to be found out.
    bool anybody_may(std::string_view permission) const;
    /// What scripts with the permissions see from now on.
    void see(std::optional<Vec2> cursor, std::vector<Rect> windows);
    /// Told in the next run, which is due at once.
    void tell(ScriptSetting setting);
    void tell(PressedHotkey hotkey);
    /// Commands of scripts that are not for the engine (Store, Notify, Hotkey), since the last
    /// call.
    std::vector<ScriptCommand> take_wishes() { return std::exchange(wishes_, {}); }
    /// The first error of each script since it was loaded, a line each.
    const std::vector<std::string>& problems() const { return problems_; }

private:
    PetKey key_of(PetId id) const;
    PetId id_of(PetKey key) const;
    ScriptWorld snapshot(const Engine& engine, const std::vector<Monitor>& monitors, Ticks now);
    void exchange(Engine& engine, const ScriptWorld& world);
    void remember_problem(const ScriptLog& line);
    void apply(Engine& engine, const ScriptCommand& command);
    void forget_removed(const Engine& engine);

    std::unique_ptr<ScriptHost> host_;
    bool loaded_ = false;
    Ticks next_wake_ = never;
    std::vector<std::string> permissions_;  // Of all scripts together.
    std::optional<Vec2> cursor_;
    std::vector<Rect> windows_;
    std::vector<ScriptSetting> new_settings_;
    std::vector<PressedHotkey> pressed_hotkeys_;
    std::vector<ScriptCommand> wishes_;
    std::vector<std::string> problems_;
    std::vector<std::string> troubled_;  // The scripts that problems_ are of.
    // Pets that scripts spawned, both ways; all others have keys made from their ids.
    std::unordered_map<PetKey, PetId> made_;
    std::unordered_map<PetKey, PetKey> made_key_of_;
};

}  // namespace hyrax
