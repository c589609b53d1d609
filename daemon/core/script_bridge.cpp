// SPDX-License-Identifier: MIT
#include "daemon/core/script_bridge.h"

#include <spdlog/spdlog.h>

#include <type_traits>
#include <utility>

namespace hyrax {
namespace {

// Generations stay below 2^31 for any life of the program, so the top bit is free.
PetKey packed(PetId id) {
    return (PetKey{id.generation} << 32U) | id.index;
}

PetId unpacked(PetKey key) {
    return {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32U)};
}

const char* state_name(Motion motion) {
    switch (motion) {
        case Motion::airborne:
            return "fall";
        case Motion::settled:
            return "idle";
        case Motion::held:
            return "held";
    }
    std::unreachable();
}

// The name of what would move or make a pet; empty for anything else.
struct MovingVerb {
    std::string_view operator()(const command::Spawn&) const { return "spawn"; }
    std::string_view operator()(const command::Fling&) const { return "fling"; }
    std::string_view operator()(const command::Push&) const { return "push"; }
    std::string_view operator()(const command::MoveTo&) const { return "move_to"; }
    std::string_view operator()(const command::Reset&) const { return "reset"; }
    std::string_view operator()(const auto&) const { return {}; }
};

void write_log(const ScriptLog& line) {
    constexpr spdlog::level::level_enum levels[] = {
        spdlog::level::info, spdlog::level::warn, spdlog::level::err
    };
    // Errors begin with the script's name and the line.
    const std::string prefix = line.script + ": ";
    const bool located = line.text.starts_with(line.script + ":");
    spdlog::log(levels[std::to_underlying(line.level)], "{}{}", located ? "" : prefix, line.text);
}

}  // namespace

void ScriptBridge::load(std::vector<ScriptSource> sources) {
    if (!host_ || (sources.empty() && !loaded_)) {
        return;
    }
    loaded_ = !sources.empty();
    errors_.clear();
    host_->load(std::move(sources));
    next_wake_ = 0;
}

void ScriptBridge::run(Engine& engine, const std::vector<Monitor>& monitors, Ticks now) {
    if (next_wake_ > now && !engine.has_events()) {
        return;
    }
    std::vector<ScriptEvent> events;
    for (const Event& event : engine.take_events()) {
        events.push_back({event, event.pet == PetId{} ? PetKey{0} : key_of(event.pet)});
    }
    const ScriptOutput output = host_->run(snapshot(engine, monitors, now), events);
    for (const ScriptLog& line : output.log) {
        write_log(line);
        if (line.level == LogLevel::error && line.text.starts_with(line.script + ":")) {
            errors_[line.script] = line.text;  // Not the lines of its call trace.
        }
    }
    engine.listen(output.listening);
    for (const ScriptCommand& command : output.commands) {
        apply(engine, command);
    }
    forget_removed(engine);
    next_wake_ = output.next_wake;
}

PetKey ScriptBridge::key_of(PetId id) const {
    const auto made = made_key_of_.find(packed(id));
    return made == made_key_of_.end() ? packed(id) : made->second;
}

PetId ScriptBridge::id_of(PetKey key) const {
    if ((key & script_made_key) == 0) {
        return unpacked(key);
    }
    const auto found = made_.find(key);
    return found == made_.end() ? PetId{} : found->second;
}

ScriptWorld ScriptBridge::snapshot(
    const Engine& engine, const std::vector<Monitor>& monitors, Ticks now
) const {
    ScriptWorld world{.now = now, .pets = {}, .monitors = monitors, .kinds = engine.kinds()};
    world.pets.reserve(engine.size());
    engine.for_each([&](PetId id, const Pet& pet) {
        const Kind& kind = engine.kinds()[pet.kind];
        world.pets.push_back({
            .key = key_of(id),
            .kind = kind.name,
            .owner = pet.owner,
            .tag = pet.tag,
            .position = pet.position(),
            .velocity = pet.velocity(),
            .box = kind.box,
            .state = state_name(pet.motion),
            .faces_left = pet.faces_left,
            .spawned_at = pet.spawn_position,
        });
    });
    return world;
}

void ScriptBridge::set_quiet(bool quiet) {
    quiet_ = quiet;
    refused_.clear();
}

bool ScriptBridge::refuses(const ScriptCommand& given) {
    if (!quiet_) {
        return false;
    }
    const std::string_view verb = std::visit(MovingVerb{}, given);
    if (!verb.empty() && refused_.insert(verb).second) {
        spdlog::warn(
            "script: {}: refused while hyrax is quiet (tray menu: Quiet; config.json: "
            "/overlay/quiet)",
            verb
        );
    }
    return !verb.empty();
}

void ScriptBridge::apply(Engine& engine, const ScriptCommand& given) {
    if (refuses(given)) {
        return;
    }
    const auto perform = [this, &engine](const auto& c) -> Result<void> {
        using Command = std::remove_cvref_t<decltype(c)>;
        if constexpr (std::is_same_v<Command, command::Spawn>) {
            const Result<PetId> id = engine.spawn(c.options);
            if (!id) {
                return std::unexpected(id.error());
            }
            made_.emplace(c.key, *id);
            made_key_of_.emplace(packed(*id), c.key);
            return {};
        } else {
            const PetId pet = id_of(c.pet);
            if (engine.find(pet) == nullptr) {
                return {};
            }
            if constexpr (std::is_same_v<Command, command::Fling>) {
                return engine.fling(pet, c.velocity);
            } else if constexpr (std::is_same_v<Command, command::Push>) {
                return engine.push(pet, c.change);
            } else if constexpr (std::is_same_v<Command, command::Stop>) {
                return engine.stop(pet);
            } else if constexpr (std::is_same_v<Command, command::Reset>) {
                return engine.reset(pet);
            } else if constexpr (std::is_same_v<Command, command::MoveTo>) {
                return engine.move_to(pet, c.position);
            } else if constexpr (std::is_same_v<Command, command::SetTag>) {
                return engine.set_tag(pet, c.tag);
            } else {
                static_assert(std::is_same_v<Command, command::Remove>);
                return engine.remove(pet);
            }
        }
    };
    if (const Result<void> done = std::visit(perform, given); !done) {
        spdlog::warn("script: {}", done.error().message);
    }
}

// A pet's key lives until the events of its removal have been handed over.
void ScriptBridge::forget_removed(const Engine& engine) {
    if (engine.has_events()) {
        return;
    }
    std::erase_if(made_, [&](const auto& entry) {
        if (engine.find(entry.second) != nullptr) {
            return false;
        }
        made_key_of_.erase(packed(entry.second));
        return true;
    });
}

}  // namespace hyrax
