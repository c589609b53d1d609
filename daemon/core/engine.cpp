// SPDX-License-Identifier: MIT
#include "daemon/core/engine.h"

#include "daemon/core/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyrax {
namespace {

// Written so that NaN fails.
bool is_share(double value) {
    return value >= 0.0 && value <= 1.0;
}

bool is_amount(double value) {
    return value >= 0.0 && std::isfinite(value);
}

bool is_possible(const EngineSettings& settings) {
    const PhysicsConstants& law = settings.physics;
    return is_amount(law.gravity) && is_amount(law.rest_threshold) && is_share(law.restitution) &&
           is_share(law.air_drag) && is_share(law.ground_friction) &&
           is_amount(settings.reference_rate) && settings.reference_rate > 0.0 &&
           is_amount(settings.fixed_rate) && settings.fixed_rate > 0.0 &&
           is_amount(settings.max_speed) && is_amount(settings.max_spawn_rate) &&
           is_amount(settings.forces.quadratic_drag) && std::isfinite(settings.forces.wind.x) &&
           std::isfinite(settings.forces.wind.y) && settings.scale >= least_scale &&
           settings.scale <= most_scale;
}

MotionRules rules_of(const EngineSettings& settings, Vec2 wind) {
    ForceField forces = settings.forces;
    forces.wind = forces.wind + wind;
    return {
        .integrator = forces == ForceField{} ? settings.integrator : Integrator::rk45,
        .constants = settings.physics,
        .law = law_from(settings.physics, settings.reference_rate),
        .fixed_step = 1.0 / settings.fixed_rate,
        .forces = forces,
    };
}

}  // namespace

Engine::Engine(std::vector<Kind> kinds, const EngineSettings& settings, std::uint32_t seed)
    : kinds_(std::move(kinds)), settings_(settings), rules_(rules_of(settings, {})), random_(seed) {
    HYRAX_CHECK(!kinds_.empty());
    HYRAX_CHECK(is_possible(settings));
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

Result<Pet*> Engine::pet_for(PetId id, std::string_view verb, Vec2 numbers) {
    Pet* pet = nullptr;
    const Result<void> checked = change(id, verb, numbers, [&pet](Pet& found) { pet = &found; });
    return checked ? Result<Pet*>(pet) : std::unexpected(checked.error());
}

Result<void> Engine::remove(PetId id) {
    return change(id, "remove", {}, [this, id](const Pet& pet) {
        emit({.kind = EventKind::remove, .pet = id, .tag = pet.tag});
        std::erase(awake_, id);
        std::erase_if(held_, [id](const Held& held) { return held.pet == id; });
        spaces_.release(pet.space);
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
    return change(id, "stop", {}, [this, id](Pet& pet) {
        if (pet.awake && pet.motion != Motion::held) {
            pet.walk.reset();
            set_in_motion(id, pet, {});
        }
    });
}

Result<void> Engine::reset(PetId id) {
    return change(id, "reset", {}, [this, id](Pet& pet) { put_back(id, pet); });
}

Result<void> Engine::move_to(PetId id, Vec2 position) {
    return change(id, "move_to", position, [&](Pet& pet) {
        if (pet.motion != Motion::held) {
            put(id, pet, position);
            launch(id, pet, pet.velocity());
        }
    });
}

Result<void> Engine::set_tag(PetId id, std::string tag) {
    return change(id, "tag", {}, [&tag](Pet& pet) { pet.tag = std::move(tag); });
}

Result<void> Engine::grab(PetId id, Ticks time) {
    return change(id, "grab", {}, [&](Pet& pet) {
        Spring spring(settings_.hand);
        // A hand catches a flying pet with its velocity; the spring brakes it.
        if (!spring.grab({pet.position(), pet.velocity()}, pet.position(), time)) {
            return;
        }
        std::erase_if(held_, [id](const Held& held) { return held.pet == id; });
        held_.push_back({id, spring});
        pet.motion = Motion::held;
        pet.walk.reset();
        pet.playing.reset();
        pet.since = now_;
        refresh_frozen(id, pet);
        pet.awake = false;
        std::erase(awake_, id);
        emit({.kind = EventKind::grab, .pet = id});
    });
}

Result<void> Engine::carry(PetId id, Vec2 position, Ticks time) {
    return change(id, "carry", position, [&](const Pet&) {
        Held* const hand = held(id);
        HYRAX_CHECK(hand != nullptr);
        // False for a place that no screen has, or for a clock that went back: the pet stays.
        static_cast<void>(hand->spring.follow(position, time));
    });
}

Result<void> Engine::let_go(PetId id, Ticks time, double max_speed) {
    return change(id, "let_go", {max_speed, 0.0}, [&](Pet& pet) {
        Held* const hand = held(id);
        HYRAX_CHECK(hand != nullptr);
        const Vec2 velocity = hand->spring.release_velocity(time, max_speed);
        const Vec2 position = hand->spring.at(time).position + hand->grown;
        std::erase_if(held_, [id](const Held& one) { return one.pet == id; });
        pet.motion = Motion::airborne;
        place(pet, position);
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

Result<void> Engine::configure(const EngineSettings& settings) {
    if (!is_possible(settings)) {
        return failure("settings: expected finite numbers, gravity, speeds and rates not below 0, "
                       "restitution, air_drag and ground_friction from 0 to 1");
    }
    settings_ = settings;
    rules_ = rules_of(settings, wind_);
    mind_screens();
    // A law that changed may move whoever rests; who still rests goes back to sleep.
    pets_.for_each([this](PetId id, Pet& pet) {
        refit(id, pet);
        if (pet.motion != Motion::held) {
            set_in_motion(id, pet, pet.velocity());
        }
    });
    return {};
}

Result<void> Engine::set_wind(Vec2 wind) {
    if (auto checked = require_finite(wind, "wind"); !checked || wind == wind_) {
        return checked;
    }
    wind_ = wind;
    rules_ = rules_of(settings_, wind_);
    pets_.for_each([this](PetId id, Pet& pet) {
        if (!pet.awake || pet.motion == Motion::held) {
            return;  // No wind moves who lies on the ground.
        }
        const bool flies = pet.started && !pet.walk;
        relaunch(pet, pet.velocity());
        refresh_frozen(id, pet);
        if (flies && !pet.frozen()) {
            // From the moment that is shown, so that no frame stands still.
            pet.body.start(now_ - pet.lost);
            pet.started = true;
        }
    });
    return {};
}

void Engine::set_kinds(std::vector<Kind> kinds) {
    HYRAX_CHECK(!kinds.empty());
    const std::vector<Kind> former = std::exchange(kinds_, std::move(kinds));
    pets_.for_each([this, &former](PetId id, Pet& pet) {
        pet.kind = kind_named(former[pet.kind].name).value_or(0);
        fit(id, pet);
        if (!arena_.empty() && pet.motion != Motion::held) {
            place(pet, pet.position());
            set_in_motion(id, pet, pet.velocity());
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

Engine::Held* Engine::held(PetId id) {
    const auto found = std::ranges::find(held_, id, &Held::pet);
    return found == held_.end() ? nullptr : &*found;
}

void Engine::place(Pet& pet, Vec2 position) {
    const Size size = box_of(pet);
    const FreeSpace& space = spaces_[pet.space];
    pet.shown.position = space.nearest(position + space.overhang()) - space.overhang();
    const Vec2 at = pet.shown.position;
    pet.home = arena_.box_near({at.x + size.width / 2.0, at.y + size.height / 2.0});
}

void Engine::set_in_motion(PetId id, Pet& pet, Vec2 velocity) {
    relaunch(pet, velocity);
    refresh_frozen(id, pet);
    if (!pet.awake) {
        pet.awake = true;
        if (!pet.frozen()) {
            awake_.push_back(id);
        }
    }
}

void Engine::launch(PetId id, Pet& pet, Vec2 velocity) {
    if (pet.motion == Motion::held) {
        return;
    }
    pet.walk.reset();
    pet.playing.reset();
    set_in_motion(id, pet, capped(velocity));
    pet.motion = Motion::airborne;
    pet.since = now_;
    pet.landed = false;
}

void Engine::put_back(PetId id, Pet& pet) {
    if (pet.motion == Motion::held) {
        return;
    }
    put(id, pet, pet.spawn_position);
    launch(id, pet, {});
}

Vec2 Engine::capped(Vec2 velocity) const {
    // hypot of a huge vector may overflow to infinity, so shorten each component first.
    const double limit = settings_.max_speed;
    const Vec2 within{std::clamp(velocity.x, -limit, limit), std::clamp(velocity.y, -limit, limit)};
    const double speed = std::hypot(within.x, within.y);
    return speed > limit ? within * (limit / speed) : within;
}

void Engine::emit(const Event& event) {
    if (listening_.has(event.kind)) {
        events_.push_back(event);
    }
    if (watching_.has(event.kind)) {
        watched_.push_back(event);
    }
}

}  // namespace hyrax
