// SPDX-License-Identifier: MIT
#include "daemon/core/engine.h"

#include "daemon/core/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyrax {
namespace {

Result<void> require_finite(Vec2 v, std::string_view verb) {
    if (std::isfinite(v.x) && std::isfinite(v.y)) {
        return {};
    }
    return failure(fmt::format("{}: expected finite numbers, got ({}, {})", verb, v.x, v.y));
}

}  // namespace

Engine::Engine(std::vector<Kind> kinds, const EngineSettings& settings, std::uint32_t seed)
    : kinds_(std::move(kinds)), settings_(settings), random_(seed) {
    HYRAX_CHECK(!kinds_.empty());
}

Result<PetId> Engine::spawn(const SpawnOptions& options) {
    const std::optional<std::size_t> kind = kind_named(options.kind);
    if (!kind) {
        return failure(fmt::format("spawn: there is no kind of pet named \"{}\"", options.kind));
    }
    if (pets_.size() >= settings_.max_pets) {
        return failure(fmt::format(
            "spawn: the population limit of {} pets is reached (config.json: /pets/max)",
            settings_.max_pets
        ));
    }
    if (arena_.empty()) {
        return failure("spawn: no monitor is known, so there is no place for a pet");
    }
    for (const Vec2 numbers : {options.velocity, options.at.value_or(Vec2{})}) {
        if (const auto checked = require_finite(numbers, "spawn"); !checked) {
            return std::unexpected(checked.error());
        }
    }

    Pet pet;
    pet.kind = *kind;
    pet.owner = options.owner;
    pet.tag = options.tag;
    pet.body.setConstants(settings_.physics);
    place(pet, options.at ? *options.at : random_entrance());
    pet.spawn_position = pet.position();
    const PetId id = pets_.insert(std::move(pet));
    launch(id, *pets_.find(id), options.velocity);
    emit({.kind = EventKind::spawn, .pet = id});
    return id;
}

template <typename Act>
Result<void> Engine::change(PetId id, std::string_view verb, Vec2 numbers, Act act) {
    Pet* const pet = pets_.find(id);
    if (pet == nullptr) {
        return failure(fmt::format("{}: this pet is gone", verb));
    }
    if (auto checked = require_finite(numbers, verb); !checked) {
        return checked;
    }
    act(*pet);
    return {};
}

Result<void> Engine::remove(PetId id) {
    return change(id, "remove", {}, [this, id](const Pet& pet) {
        emit({.kind = EventKind::remove, .pet = id, .tag = pet.tag});
        std::erase(awake_, id);
        pets_.erase(id);
    });
}

Result<void> Engine::fling(PetId id, Vec2 velocity) {
    return change(id, "fling", velocity, [&](Pet& pet) { launch(id, pet, velocity); });
}

Result<void> Engine::push(PetId id, Vec2 impulse) {
    return change(id, "push", impulse, [&](Pet& pet) {
        launch(id, pet, pet.velocity() + impulse);
    });
}

Result<void> Engine::stop(PetId id) {
    return change(id, "stop", {}, [](Pet& pet) { pet.body.resetVelocity(); });
}

Result<void> Engine::reset(PetId id) {
    return change(id, "reset", {}, [this, id](Pet& pet) { put_back(id, pet); });
}

Result<void> Engine::move_to(PetId id, Vec2 position) {
    return change(id, "move_to", position, [&](Pet& pet) {
        if (pet.motion != Motion::held) {
            place(pet, position);
            launch(id, pet, pet.velocity());
        }
    });
}

Result<void> Engine::set_tag(PetId id, std::string tag) {
    return change(id, "tag", {}, [&tag](Pet& pet) { pet.tag = std::move(tag); });
}

Result<void> Engine::grab(PetId id) {
    return change(id, "grab", {}, [this, id](Pet& pet) {
        pet.motion = Motion::held;
        pet.since = now_;
        pet.awake = false;
        pet.body.resetVelocity();
        std::erase(awake_, id);
        emit({.kind = EventKind::grab, .pet = id});
    });
}

Result<void> Engine::carry(PetId id, Vec2 position) {
    return change(id, "carry", position, [position](Pet& pet) {
        HYRAX_CHECK(pet.motion == Motion::held);
        // A hand may hold a pet across a seam: only letting go puts it back into a box.
        pet.body.setPos(position.x - pet.home.x, position.y - pet.home.y);
    });
}

Result<void> Engine::let_go(PetId id, Vec2 velocity) {
    return change(id, "let_go", velocity, [&](Pet& pet) {
        HYRAX_CHECK(pet.motion == Motion::held);
        pet.motion = Motion::airborne;
        place(pet, pet.position());
        launch(id, pet, velocity);
        emit({.kind = EventKind::throw_pet, .pet = id, .velocity = pet.velocity()});
    });
}

void Engine::click(PetId id, Button button) {
    if (pets_.find(id) != nullptr) {
        emit({.kind = EventKind::click, .pet = id, .button = button});
    }
}

void Engine::reset_all() {
    pets_.for_each([this](PetId id, Pet& pet) { put_back(id, pet); });
}

void Engine::clear() {
    std::vector<PetId> all;
    pets_.for_each([&all](PetId id, const Pet&) { all.push_back(id); });
    for (const PetId id : all) {
        const Result<void> removed = remove(id);
        HYRAX_CHECK(removed.has_value());
    }
}

void Engine::fling_all() {
    pets_.for_each([this](PetId id, Pet& pet) {
        const double sideways = (random_unit() * 2.0 - 1.0) * 1200.0;
        const double upwards = 600.0 + random_unit() * 700.0;
        launch(id, pet, {sideways, -upwards});
    });
}

void Engine::set_arena(Arena arena) {
    arena_ = std::move(arena);
    emit({.kind = EventKind::monitors});
    if (arena_.empty()) {
        return;
    }
    pets_.for_each([this](PetId id, Pet& pet) {
        if (pet.motion == Motion::held) {
            return;
        }
        const Vec2 before = pet.position();
        place(pet, before);
        if (pet.position() != before) {
            pet.body.resetVelocity();
        }
        wake(id, pet);
    });
}

void Engine::configure(const EngineSettings& settings) {
    settings_ = settings;
    pets_.for_each([this](PetId id, Pet& pet) {
        pet.body.setConstants(settings_.physics);
        // A law that changed may move whoever rests; who still rests goes back to sleep.
        if (pet.motion != Motion::held) {
            wake(id, pet);
        }
    });
}

void Engine::set_kinds(std::vector<Kind> kinds) {
    HYRAX_CHECK(!kinds.empty());
    const std::vector<Kind> former = std::exchange(kinds_, std::move(kinds));
    pets_.for_each([this, &former](PetId id, Pet& pet) {
        pet.kind = kind_named(former[pet.kind].name).value_or(0);
        if (!arena_.empty() && pet.motion != Motion::held) {
            place(pet, pet.position());
            wake(id, pet);
        }
    });
}

std::vector<Event> Engine::take_events() {
    return std::exchange(events_, {});
}

std::optional<std::size_t> Engine::kind_named(std::string_view name) const {
    const auto found = std::ranges::find(kinds_, name, &Kind::name);
    if (found == kinds_.end()) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - kinds_.begin());
}

void Engine::place(Pet& pet, Vec2 position) {
    const Size size = box_of(pet);
    const Vec2 centre{position.x + size.width / 2.0, position.y + size.height / 2.0};
    pet.home = arena_.box_near(centre);
    const Vec2 place = fitted(position, size, pet.home);
    pet.body.setPos(place.x - pet.home.x, place.y - pet.home.y);
}

void Engine::launch(PetId id, Pet& pet, Vec2 velocity) {
    if (pet.motion == Motion::held) {
        return;
    }
    const Vec2 allowed = capped(velocity);
    pet.body.setVelocity(allowed.x, allowed.y);
    pet.motion = Motion::airborne;
    pet.since = now_;
    pet.landed = false;
    pet.frames_on_floor = 0;
    wake(id, pet);
}

void Engine::put_back(PetId id, Pet& pet) {
    if (pet.motion == Motion::held) {
        return;
    }
    place(pet, pet.spawn_position);
    launch(id, pet, {});
}

void Engine::wake(PetId id, Pet& pet) {
    if (pet.awake) {
        return;
    }
    pet.awake = true;
    pet.stepped_at.reset();
    awake_.push_back(id);
}

Vec2 Engine::capped(Vec2 velocity) const {
    // hypot of a huge vector may overflow to infinity, so shorten each component first.
    const double limit = settings_.max_speed;
    const Vec2 within{std::clamp(velocity.x, -limit, limit), std::clamp(velocity.y, -limit, limit)};
    const double speed = std::hypot(within.x, within.y);
    return speed > limit ? within * (limit / speed) : within;
}

Vec2 Engine::random_entrance() {
    const std::vector<Rect>& boxes = arena_.boxes();
    const auto index = static_cast<std::size_t>(random_unit() * static_cast<double>(boxes.size()));
    const Rect& box = boxes[std::min(index, boxes.size() - 1)];
    return {box.x + random_unit() * box.width, static_cast<double>(box.y)};
}

double Engine::random_unit() {
    // minstd_rand is specified to the bit; the library's distributions are not.
    return static_cast<double>(random_() - std::minstd_rand::min()) /
           (static_cast<double>(std::minstd_rand::max() - std::minstd_rand::min()) + 1.0);
}

void Engine::emit(const Event& event) {
    if (listening_.has(event.kind)) {
        events_.push_back(event);
    }
}

}  // namespace hyrax
