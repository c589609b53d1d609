// SPDX-License-Identifier: MIT
// What people who write scripts ask of the daemon.
#include "daemon/core/daemon.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hyrax {

std::vector<ScriptStatus> Daemon::script_states() const {
    const std::vector<std::string> ended = scripts_.ended();
    std::vector<ScriptStatus> states;
    const auto add = [&](const std::string& name) {
        const auto source = std::ranges::find(sources_, name, &ScriptSource::name);
        states.push_back({
            .name = name,
            .bytes = source != sources_.end() ? source->text.size() : 0,
            .on = source != sources_.end(),
            .ended = std::ranges::find(ended, name) != ended.end(),
            .error = error_of(name),
            .pets = pets_of(name),
            .use = use_of(name),
        });
    };
    for (const std::string& name : script_names_) {
        add(name);
    }
    for (const ScriptSource& script : session_scripts_.all()) {
        add(script.name);
    }
    return states;
}

std::size_t Daemon::pets_of(const std::string& owner) const {
    std::size_t pets = 0;
    engine_.for_each([&](PetId, const Pet& pet) { pets += pet.owner == owner ? 1U : 0U; });
    return pets;
}

Result<std::string> Daemon::find_script(std::string_view name) const {
    const std::vector<ScriptStatus> states = script_states();
    for (const std::string& wanted :
         {std::string(name), std::string(SessionScripts::prefix).append(name)}) {
        if (std::ranges::find(states, wanted, &ScriptStatus::name) != states.end()) {
            return wanted;
        }
    }
    std::vector<std::string_view> known;
    for (const ScriptStatus& state : states) {
        known.push_back(state.name);
    }
    return failure(
        known.empty()
            ? fmt::format("there is no script \"{}\"; there is none at all", name)
            : fmt::format("there is no script \"{}\"; known: {}", name, fmt::join(known, ", "))
    );
}

Result<std::string> Daemon::run_script(std::string_view name, std::string text) {
    Result<std::string> script = session_scripts_.put(name, std::move(text));
    if (script) {
        read_scripts();
    }
    return script;
}

bool Daemon::stop_script(std::string_view name) {
    const bool was_there = session_scripts_.remove(name);
    read_scripts();
    return was_there;
}

void Daemon::restart_script(const std::string& script) {
    session_scripts_.restart(script);
    read_scripts();
}

Result<std::uint64_t> Daemon::evaluate(const std::string& script, std::string text) {
    constexpr std::size_t most_waiting = 16;
    if (scripts_.waiting_evaluations() >= most_waiting) {
        return failure("scripts are busy: too many evaluations wait for them");
    }
    return scripts_.evaluate(script, std::move(text));
}

std::string Daemon::why_scripts_rest() const {
    if (paused_) {
        return "scripts stand still while hyrax is paused: hyraxctl resume";
    }
    if (remembered_.hidden) {
        return "scripts stand still while the pets are hidden: hyraxctl show";
    }
    return presence_.decisions().unseen ? "scripts stand still while nobody sees the pets" : "";
}

}  // namespace hyrax
