// SPDX-License-Identifier: MIT
// What scripts ask for, carried out: which pet a key means, what may be done, and how.
#include "daemon/core/script_bridge.h"

#include <spdlog/spdlog.h>

#include <string>
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

// The name of what would move or make a pet; empty for anything else.
struct MovingVerb {
    std::string_view operator()(const command::Spawn&) const { return "spawn"; }
    std::string_view operator()(const command::Fling&) const { return "fling"; }
    std::string_view operator()(const command::Push&) const { return "push"; }
    std::string_view operator()(const command::MoveTo&) const { return "move_to"; }
    std::string_view operator()(const command::Reset&) const { return "reset"; }
    std::string_view operator()(const command::WalkTo&) const { return "walk_to"; }
    std::string_view operator()(const command::Wind& wind) const {
        return wind.velocity == Vec2{} ? "" : "wind";
    }
    std::string_view operator()(const auto&) const { return {}; }
};

}  // namespace

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

bool ScriptBridge::must_stay(const Pet& pet) const {
    return calm_ && (pet.motion == Motion::settled || pet.motion == Motion::walking);
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

void ScriptBridge::apply_commands(Engine& engine) {
    std::size_t failures = 0;
    std::string first;
    for (std::size_t i = 0; i < most_commands && !commands_.empty(); ++i) {
        if (Result<void> done = apply(engine, commands_.front()); !done && failures++ == 0) {
            first = std::move(done.error().message);
        }
        commands_.pop_front();
    }
    if (failures == 1) {
        spdlog::warn("script: {}", first);
    } else if (failures > 1) {
        spdlog::warn("script: {} (and {} other failures)", first, failures - 1);
    }
}

Result<void> ScriptBridge::apply(Engine& engine, const ScriptCommand& given) {
    if (refuses(given)) {
        return {};
    }
    const auto perform = [this, &engine](const auto& c) -> Result<void> {
        using Command = std::remove_cvref_t<decltype(c)>;
        if constexpr (std::is_same_v<Command, command::Spawn>) {
            if (retired_.contains(c.options.owner)) {
                return {};
            }
            if (made_.contains(c.key)) {
                return failure("spawn: its key belongs to another pet");
            }
            const Result<PetId> id = engine.spawn(c.options);
            if (!id) {
                return std::unexpected(id.error());
            }
            made_.emplace(c.key, *id);
            made_key_of_.emplace(packed(*id), c.key);
            return {};
        } else if constexpr (std::is_same_v<Command, command::Store> ||
                             std::is_same_v<Command, command::Notify> ||
                             std::is_same_v<Command, command::Hotkey>) {
            wishes_.emplace_back(c);
            return {};
        } else if constexpr (std::is_same_v<Command, command::Wind>) {
            blow(engine, c.script, c.velocity);
            return {};
        } else {
            const PetId pet = id_of(c.pet);
            const Pet* const found = engine.find(pet);
            if (found == nullptr) {
                return {};
            }
            constexpr bool flies =
                std::is_same_v<Command, command::Fling> || std::is_same_v<Command, command::Push>;
            // Who is in the air would walk off as soon as it stands.
            constexpr bool walks = std::is_same_v<Command, command::WalkTo>;
            if ((flies && must_stay(*found)) || (walks && calm_)) {
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
            } else if constexpr (std::is_same_v<Command, command::WalkTo>) {
                return engine.walk_to(pet, c.x, c.speed);
            } else if constexpr (std::is_same_v<Command, command::Play>) {
                return engine.play(pet, {c.animation, c.loop, c.fps});
            } else if constexpr (std::is_same_v<Command, command::Say>) {
                return engine.say(pet, c.text, c.seconds);
            } else if constexpr (std::is_same_v<Command, command::SetScale>) {
                return engine.set_scale(pet, c.scale);
            } else if constexpr (std::is_same_v<Command, command::Face>) {
                return engine.face(pet, c.left);
            } else {
                static_assert(std::is_same_v<Command, command::Remove>);
                return engine.remove(pet);
            }
        }
    };
    return std::visit(perform, given);
}

}  // namespace hyrax
