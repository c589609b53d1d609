// SPDX-License-Identifier: MIT
// The door between the daemon and the scripts: plain data only, so that scripts can live in a
// process of their own. A snapshot and events go in, commands come out.
#pragma once

#include "daemon/core/arena.h"
#include "daemon/core/engine.h"
#include "daemon/core/event.h"
#include "daemon/core/script_limits.h"
#include "daemon/core/script_value.h"
#include "physics/ticks.h"

#include <array>
#include <chrono>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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
    std::string state{};  ///< "fall", "idle", "walk" or "held".
    bool faces_left = false;
    double scale = 1.0;                ///< Its own, least_scale to most_scale.
    std::optional<Vec2> spawned_at{};  ///< Where reset() puts it [px]; none: not known.
};

/// As command::Hotkey named it.
struct PressedHotkey {
    std::string script;
    std::uint64_t id = 0;
    bool operator==(const PressedHotkey&) const = default;
};

/// A text to run in a script, for somebody who writes it.
struct Evaluation {
    std::uint64_t id = 0;
    std::string script;
    std::string text;  ///< An expression or statements; empty: only whether the script runs.
};

/// What came of an evaluation.
struct Evaluated {
    std::uint64_t id = 0;
    bool good = false;
    std::string text{};     ///< The values, as people read them, or the error.
    std::string printed{};  ///< What it wrote into the log until it first waited, line by line.
};

/// The world at one moment. A pet that is not listed is gone.
struct ScriptWorld {
    Ticks now = 0;
    std::vector<PetView> pets;
    std::vector<Monitor> monitors;
    /// What spawn() can be asked for; empty: not known, the engine decides.
    std::vector<Kind> kinds{};
    std::optional<Vec2> cursor{};  ///< Where a script may know it [px]; none: not known.
    std::vector<Rect> windows{
    };  ///< Of other programs, the topmost first, where a script may know.
    std::vector<PressedHotkey> pressed_hotkeys{};
    std::vector<Evaluation> evaluations{};
    /// The daemon ends: scripts hear it in `unload`, and nothing afterwards.
    bool ending = false;
};

struct ScriptEvent {
    Event event;       ///< Its ids of pets mean nothing here.
    PetKey pet = 0;    ///< 0 where the event is about no pet.
    PetKey other = 0;  ///< collide: whom it met.
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
struct WalkTo {
    PetKey pet = 0;
    double x = 0.0;
    double speed = 0.0;  ///< [px/s]
};
struct Play {
    PetKey pet = 0;
    std::string animation;
    std::optional<bool> loop;   ///< None: as the animation is made.
    std::optional<double> fps;  ///< None: as its frames last.
};
struct Say {
    PetKey pet = 0;
    std::string text;      ///< Empty: the bubble goes.
    double seconds = 0.0;  ///< How long it stays.
};
struct SetScale {
    PetKey pet = 0;
    double scale = 1.0;  ///< least_scale to most_scale
};
struct Face {
    PetKey pet = 0;
    bool left = false;
};
/// A script keeps a value under a key, or forgets it where the value is nothing.
struct Store {
    std::string script;
    std::string key;
    ScriptValue value;
};
struct Notify {
    std::string script;
    std::string text;
};
/// The script's share of the wind, instead of what it was [px/s].
struct Wind {
    std::string script;
    Vec2 velocity;
};
struct Hotkey {
    std::string script;
    std::uint64_t id = 0;  ///< Unique in its script until that is loaded again.
    std::string keys;      ///< "ctrl+alt+h"; empty: the hotkey is no longer wanted.
    std::string label;
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
    command::Remove,
    command::WalkTo,
    command::Play,
    command::Say,
    command::SetScale,
    command::Face,
    command::Store,
    command::Notify,
    command::Hotkey,
    command::Wind>;

enum class LogLevel { info, warning, error };

struct ScriptLog {
    LogLevel level = LogLevel::info;
    std::string script;
    std::string text;  ///< Errors begin with the script's name and the line.

    /// Whether the text does: "fountain.lua:3: ..." or "catch/score.lua:3: ...".
    bool has_place() const {
        return text.starts_with(script) && (text.substr(script.size()).starts_with(':') ||
                                            text.substr(script.size()).starts_with('/'));
    }
};

/// A case of hyrax.test that has ended.
struct ScriptTest {
    std::string script;
    std::string name;
    std::string problem;   ///< Empty: it passed.
    double seconds = 0.0;  ///< Of the pets' time.
};

/// What a script has come to since its text was loaded.
struct ScriptUse {
    std::string script;
    std::uint64_t units = 0;   ///< Of work, all calls together.
    std::uint64_t memory = 0;  ///< Of its Lua state now [bytes].
    std::uint64_t errors = 0;  ///< Repeated ones, too.
    EventMask listening{};
    bool operator==(const ScriptUse&) const = default;
};

/// What scripts did in one run.
struct ScriptOutput {
    std::vector<ScriptCommand> commands;  ///< In the order in which they were given.
    std::vector<ScriptLog> log;
    EventMask listening;      ///< The events that some handler waits for.
    Ticks next_wake = never;  ///< The next timer or tick.
    /// Places, in what was loaded, of texts that do not run: ended by their limits, or not loaded
    /// because of an error.
    std::vector<std::uint32_t> ended{};
    std::vector<ScriptTest> tests{};
    std::size_t open_tests = 0;  ///< Cases that have not ended yet.
    /// Nothing is left of the scripts' state: what they have asked of the desktop is void. Never
    /// said by scripts.
    bool lost = false;
    std::vector<Evaluated> evaluated{};
    std::vector<ScriptUse> uses{};  ///< Of those for whom it has changed in this run.
    /// Names of scripts that were killed too often to run again. Not over the wire.
    std::vector<std::string> given_up{};
};

/// The version of what scripts can call. A plugin that asks for the same major and no later minor
/// runs.
inline constexpr int script_api_major = 1;
inline constexpr int script_api_minor = 0;

/// What a script may be allowed beyond its own pets.
inline constexpr std::array<std::string_view, 6> script_permissions{
    "cursor", "hotkeys", "notify", "pets.others", "wind", "windows"
};

/// Text that a script's `require` finds.
struct ScriptModule {
    std::string name;  ///< "lib.score"
    std::string text;
    auto operator<=>(const ScriptModule&) const = default;
};

/// A script's text under the name that messages use, and what comes with it.
struct ScriptSource {
    std::string name;  ///< "fountain.lua"
    std::string text;
    std::string version{};                   ///< Of a plugin; empty: a script.
    std::string file{};                      ///< The name's file in a plugin: "main.lua".
    std::vector<ScriptModule> modules{};     ///< Of a plugin; no name twice.
    std::vector<std::string> permissions{};  ///< Of script_permissions.
    ScriptTable config{};                    ///< The user's settings of it.
    ScriptTable store{};                     ///< What it has kept so far.
    bool keep_pets = true;                   ///< When another text takes its place.
    bool testing = false;                    ///< It gets hyrax.test, and its cases run.
    std::uint64_t turn = 0;                  ///< With another one the same text starts again.
    bool operator==(const ScriptSource&) const = default;

    bool has_text_of(const ScriptSource& other) const {
        return text == other.text && modules == other.modules && turn == other.turn;
    }
};

/// Runs scripts. A script that fails is reported in the log of the next output and never stops
/// the others.
class ScriptHost {
public:
    ScriptHost() = default;
    ScriptHost(const ScriptHost&) = delete;
    ScriptHost& operator=(const ScriptHost&) = delete;
    virtual ~ScriptHost() = default;

    /// Counts from the next load() on, for every script.
    virtual void set_limits(const ScriptLimits& /*limits*/) {}
    /// These are to run from the next run() on. Who runs with the same text goes on, and hears of
    /// changed settings; who has another text is replaced once the new one has been loaded without
    /// an error, and goes on otherwise; who is not named is unloaded.
    virtual void load(std::vector<ScriptSource> sources) = 0;
    /// The next load() takes every text for a new one, those that were ended too.
    virtual void renew() {}
    /// Runs what is due: main chunks, handlers of the events, timers up to `world.now`. A host that
    /// works elsewhere only sends the order, is then busy(), and has its output later.
    virtual ScriptOutput run(const ScriptWorld& world, std::span<const ScriptEvent> events) = 0;

    /// Those of the loaded that do not run: ended by their limits, or never loaded well.
    virtual std::vector<std::string> ended() const { return {}; }

    // --- for hosts that work elsewhere; no call waits ---

    /// True while run() must not be called, because the scripts are still at work on the last one.
    virtual bool busy() const { return false; }
    /// What the last run() came to, once.
    virtual std::optional<ScriptOutput> take_output() { return std::nullopt; }
    /// Hears what the scripts' process says, and ends it when it hangs. `now`: the machine's clock.
    virtual void watch(Ticks /*now*/) {}
    /// When watch() wants to be called, at the latest [machine's clock].
    virtual Ticks watch_due() const { return never; }
    /// The exception: waits until watch() has something to hear, at most so long. False: nothing
    /// will come.
    virtual bool wait(std::chrono::milliseconds /*patience*/) { return false; }
};

}  // namespace hyrax
