// SPDX-License-Identifier: MIT
#include "daemon/core/script_bridge.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace hyrax {
namespace {

const char* state_name(Motion motion) {
    switch (motion) {
        case Motion::airborne:
            return "fall";
        case Motion::settled:
            return "idle";
        case Motion::held:
            return "held";
        case Motion::walking:
            return "walk";
    }
    std::unreachable();
}

// Who does not name the function in its text does not call it: for that nothing is found out.
struct Looks {
    std::string_view permission;
    bool operator()(const ScriptSource& source) const {
        const auto names_it = [this](const ScriptModule& module) {
            return module.text.contains(permission);
        };
        return std::ranges::find(source.permissions, permission) != source.permissions.end() &&
               (source.text.contains(permission) || std::ranges::any_of(source.modules, names_it));
    }
};

bool is_hotkey(const ScriptCommand& given) {
    return std::holds_alternative<command::Hotkey>(given);
}

void write_log(const ScriptLog& line) {
    constexpr spdlog::level::level_enum levels[] = {
        spdlog::level::info, spdlog::level::warn, spdlog::level::err
    };
    // Errors begin with the script's name and the line.
    const std::string prefix = line.script + ": ";
    spdlog::log(
        levels[std::to_underlying(line.level)], "{}{}", line.has_place() ? "" : prefix, line.text
    );
}

}  // namespace

void ScriptBridge::load(std::vector<ScriptSource> sources) {
    if (!host_ || (sources.empty() && !loaded_)) {
        return;
    }
    loaded_ = true;
    unloading_ = sources.empty();
    watch_cursor_ = std::ranges::any_of(sources, Looks{"cursor"});
    watch_windows_ = std::ranges::any_of(sources, Looks{"windows"});
    std::map<std::string, ScriptSource> texts;
    for (const ScriptSource& source : sources) {
        ScriptSource& known = texts[source.name];
        known.text = source.text;
        known.modules = source.modules;
        known.turn = source.turn;
        retired_.erase(source.name);
    }
    std::erase_if(errors_, [&](const auto& error) {
        const auto now = texts.find(error.first);
        const auto before = texts_.find(error.first);
        return now == texts.end() || before == texts_.end() ||
               !now->second.has_text_of(before->second);
    });
    std::erase_if(uses_, [&](const auto& use) { return !texts.contains(use.first); });
    texts_ = std::move(texts);
    pressed_hotkeys_.clear();
    host_->load(std::move(sources));
    next_wake_ = 0;
}

void ScriptBridge::renew() {
    errors_.clear();
    if (host_) {
        host_->renew();
    }
}

void ScriptBridge::set_limits(const ScriptLimits& limits) {
    if (host_) {
        host_->set_limits(limits);
    }
}

void ScriptBridge::watch(Ticks now) {
    if (host_) {
        host_->watch(now);
    }
}

Ticks ScriptBridge::next_wake() const {
    if (!commands_.empty()) {
        return 0;
    }
    return host_ && host_->busy() ? never : next_wake_;
}

void ScriptBridge::run(
    Engine& engine, const std::vector<Monitor>& monitors, Ticks now, const ScriptEyes& eyes
) {
    if (!loaded_) {
        return;
    }
    queue_events(engine);
    if (std::optional<ScriptOutput> output = host_->take_output()) {
        use(engine, *std::move(output));
    }
    const bool due = next_wake_ <= now || !events_.empty();
    if (due && commands_.empty() && !host_->busy()) {
        const std::vector<ScriptEvent> events = take_queue();
        ScriptWorld world = snapshot(engine, monitors, now);
        if (watch_cursor_ && eyes.cursor) {
            world.cursor = eyes.cursor();
        }
        if (watch_windows_ && eyes.windows) {
            world.windows = eyes.windows();
        }
        use(engine, host_->run(world, events));
    }
    apply_commands(engine);
    forget_removed(engine);
    if (unloading_ && next_wake() == never && !host_->busy()) {
        loaded_ = unloading_ = false;
    }
}

void ScriptBridge::queue_events(Engine& engine) {
    for (const Event& event : engine.take_events()) {
        events_.push_back({
            event,
            event.pet == PetId{} ? PetKey{0} : key_of(event.pet),
            event.other == PetId{} ? PetKey{0} : key_of(event.other),
        });
    }
    while (events_.size() > most_events) {
        events_.pop_front();
        ++dropped_events_;
    }
    if (dropped_events_ > 0 && !host_->busy()) {
        spdlog::warn(
            "scripts were too slow: {} events were dropped", std::exchange(dropped_events_, 0)
        );
    }
}

std::vector<ScriptEvent> ScriptBridge::take_queue() {
    std::vector<ScriptEvent> events(events_.begin(), events_.end());
    events_.clear();
    return events;
}

void ScriptBridge::tell(PressedHotkey hotkey) {
    if (loaded_ && pressed_hotkeys_.size() < most_pressed) {
        pressed_hotkeys_.push_back(std::move(hotkey));
        next_wake_ = 0;
    }
}

std::uint64_t ScriptBridge::evaluate(std::string script, std::string text) {
    watch_cursor_ = watch_cursor_ || text.contains("cursor");
    watch_windows_ = watch_windows_ || text.contains("windows");
    evaluations_.push_back({++last_evaluation_, std::move(script), std::move(text)});
    next_wake_ = 0;
    return last_evaluation_;
}

std::vector<std::string> ScriptBridge::ended() const {
    return host_ ? host_->ended() : std::vector<std::string>{};
}

void ScriptBridge::use(Engine& engine, ScriptOutput output) {
    for (const ScriptLog& line : output.log) {
        write_log(line);
        if (line.level == LogLevel::error && line.has_place()) {
            errors_[line.script] = line.text;  // Not the lines of its call trace.
        }
    }
    if (output.lost) {
        forget_hotkeys(output.commands);
        uses_.clear();
    }
    for (ScriptUse& use : output.uses) {
        std::string script = use.script;
        uses_[std::move(script)] = std::move(use);
    }
    engine.listen(output.listening);
    next_wake_ = output.next_wake;
    if (!evaluations_.empty()) {
        next_wake_ = 0;  // They came while scripts were at work.
    }
    std::ranges::move(output.commands, std::back_inserter(commands_));
    std::ranges::move(output.evaluated, std::back_inserter(evaluated_));
    std::ranges::move(output.given_up, std::back_inserter(given_up_));
}

// Those that were asked for and not looked at yet; the others are for who takes the loss.
void ScriptBridge::forget_hotkeys(std::vector<ScriptCommand>& answered) {
    lost_ = true;
    pressed_hotkeys_.clear();
    std::erase_if(answered, is_hotkey);
    std::erase_if(commands_, is_hotkey);
    std::erase_if(wishes_, is_hotkey);
}

ScriptWorld ScriptBridge::snapshot(
    const Engine& engine, const std::vector<Monitor>& monitors, Ticks now
) {
    ScriptWorld world{
        .now = now,
        .pets = {},
        .monitors = monitors,
        .kinds = engine.kinds(),
        .cursor = {},
        .windows = {},
        .pressed_hotkeys = std::exchange(pressed_hotkeys_, {}),
        .evaluations = std::exchange(evaluations_, {}),
    };
    for (Kind& kind : world.kinds) {
        kind.box = engine.usual_box(kind);
    }
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
            .box = engine.box_of(pet),
            .state = state_name(pet.motion),
            .faces_left = pet.faces_left,
            .scale = pet.scale,
            .spawned_at = pet.spawn_position,
        });
    });
    return world;
}

}  // namespace hyrax
