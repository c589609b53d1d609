// SPDX-License-Identifier: MIT
#include "tests/script/fake_world.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace hyrax {
namespace {

constexpr double gravity = 1200.0;
constexpr double restitution = 0.6;
constexpr Size box{100, 80};
constexpr Ticks frame = ticks_per_second / 60;

}  // namespace

FakeWorld::FakeWorld(const ScriptLimits& limits) : host_(make_script_host(limits)) {
    world.now = 1'000 * ticks_per_second;
    world.monitors = {
        {.bounds = {0, 0, 1920, 1080}, .work = {0, 0, 1920, 1040}, .primary = true, .name = "one"},
        {.bounds = {-1280, 0, 1280, 1024},
         .work = {-1280, 0, 1280, 1024},
         .primary = false,
         .name = "two"},
    };
    world.kinds = {
        {.name = "hyrax", .box = box, .animations = {"idle", "cheer"}},
        {.name = "rock", .box = {40, 40}},
    };
}

void FakeWorld::load(std::vector<ScriptSource> sources) {
    for (ScriptSource& source : sources) {
        if (source.permissions.empty()) {
            source.permissions = permissions;
        }
    }
    host_->load(std::move(sources));
    run();
}

void FakeWorld::load(std::string text, std::string name) {
    load({{.name = std::move(name), .text = std::move(text)}});
}

void FakeWorld::run() {
    const std::vector<ScriptEvent> events = std::exchange(events_, {});
    last = host_->run(world, events);
    log.insert(log.end(), last.log.begin(), last.log.end());
    tests.insert(tests.end(), last.tests.begin(), last.tests.end());
    for (const ScriptCommand& command : last.commands) {
        apply(command);
        commands.push_back(command);
    }
}

void FakeWorld::play(double seconds) {
    const Ticks end = world.now + from_seconds(seconds);
    while (world.now + frame <= end) {
        world.now += frame;
        move(to_seconds(frame));
        run();
    }
}

void FakeWorld::skip(double seconds) {
    world.now += from_seconds(seconds);
    run();
}

PetKey FakeWorld::add_pet(PetView pet) {
    pet.key = ++last_key_;
    pet.kind = pet.kind.empty() ? "hyrax" : pet.kind;
    pet.owner = pet.owner.empty() ? "user" : pet.owner;
    pet.state = pet.state.empty() ? "idle" : pet.state;
    pet.box = box;
    pet.spawned_at = pet.position;
    world.pets.push_back(pet);
    return pet.key;
}

PetView* FakeWorld::find(PetKey key) {
    const auto found = std::ranges::find(world.pets, key, &PetView::key);
    return found == world.pets.end() ? nullptr : &*found;
}

void FakeWorld::take_away(PetKey key) {
    emit({.kind = EventKind::remove, .tag = find(key)->tag}, key);
    std::erase_if(world.pets, [key](const PetView& pet) { return pet.key == key; });
}

void FakeWorld::happens(Event event, PetKey pet) {
    events_.push_back({std::move(event), pet});
}

void FakeWorld::happens_between(Event event, PetKey pet, PetKey other) {
    events_.push_back({std::move(event), pet, other});
}

void FakeWorld::emit(const Event& event, PetKey pet) {
    if (listens(event.kind)) {
        happens(event, pet);
    }
}

std::string FakeWorld::lines(LogLevel level) const {
    std::string text;
    for (const ScriptLog& line : log) {
        if (line.level == level) {
            text += line.text + "\n";
        }
    }
    return text;
}

void FakeWorld::move(double dt) {
    const Rect& floor = world.monitors.front().work;
    for (PetView& pet : world.pets) {
        if (pet.state != "fall") {
            continue;
        }
        pet.velocity.y += gravity * dt;
        pet.position = pet.position + pet.velocity * dt;
        const double lowest = floor.bottom() - pet.box.height;
        if (pet.position.y < lowest) {
            continue;
        }
        pet.position.y = lowest;
        const double speed = pet.velocity.y;
        pet.velocity = {pet.velocity.x * 0.8, -restitution * speed};
        emit({.kind = EventKind::bounce, .side = Side::bottom, .speed = speed}, pet.key);
        if (speed < 60.0) {
            pet.velocity = {};
            pet.state = "idle";
            emit({.kind = EventKind::land, .speed = speed}, pet.key);
        }
    }
}

void FakeWorld::apply(const ScriptCommand& given_command) {
    const auto perform = [this](const auto& wish) {
        using Command = std::remove_cvref_t<decltype(wish)>;
        if constexpr (std::is_same_v<Command, command::Spawn>) {
            const SpawnOptions& options = wish.options;
            world.pets.push_back({
                .key = wish.key,
                .kind = options.kind,
                .owner = options.owner,
                .tag = options.tag,
                .position = options.at.value_or(Vec2{}),
                .velocity = options.velocity,
                .box = box,
                .state = "fall",
                .faces_left = false,
                .spawned_at = options.at.value_or(Vec2{}),
            });
            emit({.kind = EventKind::spawn}, wish.key);
        } else if constexpr (std::is_same_v<Command, command::Remove>) {
            take_away(wish.pet);
        } else if constexpr (std::is_same_v<Command, command::Store> ||
                             std::is_same_v<Command, command::Notify> ||
                             std::is_same_v<Command, command::Hotkey> ||
                             std::is_same_v<Command, command::Wind>) {
            // Nothing of the world.
        } else if (PetView* const pet = find(wish.pet)) {
            if constexpr (std::is_same_v<Command, command::Fling>) {
                pet->velocity = wish.velocity;
                pet->state = "fall";
            } else if constexpr (std::is_same_v<Command, command::Push>) {
                pet->velocity = pet->velocity + wish.change;
                pet->state = "fall";
            } else if constexpr (std::is_same_v<Command, command::Stop>) {
                pet->velocity = {};
            } else if constexpr (std::is_same_v<Command, command::Reset>) {
                pet->position = pet->spawned_at.value();
                pet->velocity = {};
            } else if constexpr (std::is_same_v<Command, command::MoveTo>) {
                pet->position = wish.position;
            } else if constexpr (std::is_same_v<Command, command::SetTag>) {
                pet->tag = wish.tag;
            } else if constexpr (std::is_same_v<Command, command::SetScale>) {
                pet->scale = wish.scale;
            } else if constexpr (std::is_same_v<Command, command::Face>) {
                pet->faces_left = wish.left;
            } else if constexpr (std::is_same_v<Command, command::WalkTo>) {
                pet->position.x = wish.x;
            }
        }
    };
    std::visit(perform, given_command);
}

std::string errors_of(const std::string& text, const ScriptLimits& limits) {
    FakeWorld world(limits);
    world.load(text);
    return world.errors();
}

}  // namespace hyrax
