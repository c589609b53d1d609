// SPDX-License-Identifier: MIT
// The daemon's side of the door for tests: a virtual clock, pets that fall and bounce, and a memory
// of everything that scripts said and asked for.
#pragma once

#include "daemon/script/script_host.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

class FakeWorld {
public:
    explicit FakeWorld(const ScriptLimits& limits = {});

    /// Loads these instead of what was loaded, and runs once.
    void load(std::vector<ScriptSource> sources);
    void load(std::string text, std::string name = "test.lua");
    /// The next load() takes every text for a new one.
    void renew() { host_->renew(); }
    /// Counts from the next load() on.
    void set_limits(const ScriptLimits& limits) { host_->set_limits(limits); }
    /// One run without time passing.
    void run();
    /// Moves the clock and the pets in frames of 1/60 s, each with a run. [s]
    void play(double seconds);
    /// One run after so much time, in which nothing moves. [s]
    void skip(double seconds);

    /// A pet of the user's.
    PetKey add_pet(PetView pet = {});
    PetView* find(PetKey key);
    void take_away(PetKey key);
    /// Waits for the next run, whether or not anybody listens.
    void happens(Event event, PetKey pet);
    void happens_between(Event event, PetKey pet, PetKey other);
    bool listens(EventKind kind) const { return last.listening.has(kind); }

    /// All lines of that level, each ended by a newline.
    std::string lines(LogLevel level) const;
    std::string errors() const { return lines(LogLevel::error); }
    std::string said() const { return lines(LogLevel::info); }
    template <typename Command>
    std::vector<Command> given() const {
        std::vector<Command> found;
        for (const ScriptCommand& command : commands) {
            if (const auto* const it = std::get_if<Command>(&command)) {
                found.push_back(*it);
            }
        }
        return found;
    }

    ScriptWorld world;
    /// What every script is allowed that comes without permissions of its own.
    std::vector<std::string> permissions{script_permissions.begin(), script_permissions.end()};
    std::vector<ScriptTest> tests;
    std::vector<ScriptLog> log;
    std::vector<ScriptCommand> commands;
    ScriptOutput last;

private:
    void move(double dt);
    void apply(const ScriptCommand& command);
    void emit(const Event& event, PetKey pet);

    std::unique_ptr<ScriptHost> host_;
    std::vector<ScriptEvent> events_;
    PetKey last_key_ = 0;
};

/// Runs the text once; the errors that it caused, "" if none.
std::string errors_of(const std::string& text, const ScriptLimits& limits = {});

}  // namespace hyrax
