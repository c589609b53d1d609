// SPDX-License-Identifier: MIT
// The door between the daemon and the scripts: plain data only, so that scripts can live in a
// process of their own. A snapshot and events go in, commands come out.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/core/engine.h"
#include "daemon/core/event.h"
#include "daemon/core/script_limits.h"
#include "physics/ticks.h"

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace hyrax {

/// A pet as scripts name it. The script side invents keys for pets that it spawns, so that
/// spawn() can answer at once; keys with the top bit set are its own, others come from the daemon.
using PetKey = std::uint64_t;

inline constexpr PetKey script_made_key = PetKey{1} << 63U;

/// A pet as a script sees it.
struct PetView {
    PetKey key = 0;
    std::string kind{};
    std::string owner{};
    std::string tag{};
    Vec2 position{};  ///< Top-left corner of the box, virtual desktop [px].
    Vec2 velocity{};  ///< [px/s]
    Size box{};
    std::string state{};  ///< "fall", "idle" or "held".
    bool faces_left = false;
    std::optional<Vec2> spawned_at{};  ///< Where reset() puts it [px]; none: not known.
};

/// The world at one moment. A pet that is not listed is gone.
struct ScriptWorld {
    Ticks now = 0;
    std::vector<PetView> pets;
    std::vector<Monitor> monitors;
    /// What spawn() can be asked for; empty: not known, the engine decides.
    std::vector<Kind> kinds{};
};

struct ScriptEvent {
    Event event;     ///< Its `pet` field means nothing here.
    PetKey pet = 0;  ///< 0 where the event is about no pet.
};

namespace command {
struct Spawn {
    PetKey key = 0;  ///< Made by the script side.
    SpawnOptions options;
};
struct Fling {
    PetKey pet = 0;
    Vec2 velocity;
};
struct Push {
    PetKey pet = 0;
    Vec2 change;
};
struct Stop {
    PetKey pet = 0;
};
struct Reset {
    PetKey pet = 0;
};
struct MoveTo {
    PetKey pet = 0;
    Vec2 position;
};
struct SetTag {
    PetKey pet = 0;
    std::string tag;
};
struct Remove {
    PetKey pet = 0;
};
}  // namespace command

using ScriptCommand = std::variant<
    command::Spawn,
    command::Fling,
    command::Push,
    command::Stop,
    command::Reset,
    command::MoveTo,
    command::SetTag,
    command::Remove>;

enum class LogLevel { info, warning, error };

struct ScriptLog {
    LogLevel level = LogLevel::info;
    std::string script;
    std::string text;  ///< Errors begin with the script's name and the line.
};

/// What scripts did in one run.
struct ScriptOutput {
    std::vector<ScriptCommand> commands;  ///< In the order in which they were given.
    std::vector<ScriptLog> log;
    EventMask listening;      ///< The events that some handler waits for.
    Ticks next_wake = never;  ///< The next timer or tick.
    /// Places, in what was loaded, of the scripts that have been ended by their limits.
    std::vector<std::uint32_t> ended{};
};

/// A script's text under the name that messages use.
struct ScriptSource {
    std::string name;  ///< "fountain.lua"
    std::string text;
    auto operator<=>(const ScriptSource&) const = default;
};

/// Runs scripts. A script that fails is reported in the log of the next output and never stops
/// the others.
class ScriptHost {
public:
    ScriptHost() = default;
    ScriptHost(const ScriptHost&) = delete;
    ScriptHost& operator=(const ScriptHost&) = delete;
    virtual ~ScriptHost() = default;

    /// Counts from the next load() on.
    virtual void set_limits(const ScriptLimits& /*limits*/) {}
    /// Replaces all scripts by these; their main chunks run in the next run().
    virtual void load(std::vector<ScriptSource> sources) = 0;
    /// Runs what is due: main chunks, handlers of the events, timers up to `world.now`. A host that
    /// works elsewhere only sends the order, is then busy(), and has its output later.
    virtual ScriptOutput run(const ScriptWorld& world, std::span<const ScriptEvent> events) = 0;

    // --- for hosts that work elsewhere; no call waits ---

    /// True while run() must not be called, because the scripts are still at work on the last one.
    virtual bool busy() const { return false; }
    /// What the last run() came to, once.
    virtual std::optional<ScriptOutput> take_output() { return std::nullopt; }
    /// Hears what the scripts' process says, and ends it when it hangs. `now`: the machine's clock.
    virtual void watch(Ticks /*now*/) {}
    /// When watch() wants to be called, at the latest [machine's clock].
    virtual Ticks watch_due() const { return never; }
};

}  // namespace hyrax
