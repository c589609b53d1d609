// SPDX-License-Identifier: MIT
// Row A10 of the stability catalogue: hostile calls in any order.
#include "physics/steppers.h"
#include "tests/core/engine_seen.h"

#include <array>
#include <cstdint>
#include <limits>
#include <random>

using namespace hyrax;

namespace {

using Limits = std::numeric_limits<double>;

constexpr Rect hostile_room{-1600, -200, 1920, 1080};

// Calls every verb at random, with numbers that nobody would send on purpose.
class Attacker {
public:
    explicit Attacker(Integrator integrator)
        : integrator_(integrator), engine_({{"hyrax", box}, {"other", {50, 50}}}, settings(), 1) {
        engine_.listen(EventMask::all());
        engine_.set_arena(one_monitor(hostile_room));
    }

    void call() {
        const Seen before(engine_);
        if (!verb()) {
            REQUIRE(same(Seen(engine_), before));
            ++refused_;
        }
        check();
    }
    int refused() const { return refused_; }

private:
    static constexpr int verbs = 16;

    EngineSettings settings() const {
        return {.integrator = integrator_, .max_pets = 8, .max_speed = 1e7};
    }

    unsigned below(unsigned limit) {
        return static_cast<unsigned>(std::uint64_t{random_()} % limit);
    }

    double number() {
        constexpr std::array hostile{
            Limits::quiet_NaN(),
            Limits::infinity(),
            -Limits::infinity(),
            0.0,
            -0.0,
            Limits::denorm_min(),
            -Limits::denorm_min(),
            Limits::min(),
            Limits::epsilon(),
            Limits::max(),
            Limits::lowest(),
            1e200,
            -1e200,
            1e18,
            -1e18,
            2147483648.0,
            -1600.0,
            780.0,
            1000.0,
            -1000.0,
        };
        const unsigned index = below(2 * hostile.size());
        if (index < hostile.size()) {
            return hostile[index];
        }
        return (static_cast<double>(random_()) / 2147483647.0 - 0.5) * 4000.0;
    }
    Vec2 numbers() { return {number(), number()}; }

    // A pet that lives, or has lived.
    PetId pet() { return ids_.empty() ? PetId{} : ids_[below(static_cast<unsigned>(ids_.size()))]; }

    bool hold(PetId id, unsigned verb) {
        const Pet* const found = engine_.find(id);
        if (found == nullptr) {
            return engine_.grab(id, hand_).has_value();
        }
        hand_ += below(20) * ticks_per_ms;
        if (found->motion != Motion::held) {
            return engine_.grab(id, hand_).has_value();
        }
        return verb % 2 == 0 ? engine_.carry(id, numbers(), hand_).has_value()
                             : engine_.let_go(id, hand_, number()).has_value();
    }

    // Beyond what config.json may hold the engine promises nothing but to refuse what is no number.
    bool configure() {
        constexpr double most_gravity = 1e9;
        constexpr double most_threshold = 1e6;
        EngineSettings changed = settings();
        changed.physics = {number(), number(), number(), number(), number()};
        if (below(4) != 0) {
            const auto share = [this] { return std::min(std::fabs(number()), 1.0); };
            changed.physics = {std::fabs(number()), share(), share(), share(), std::fabs(number())};
        }
        PhysicsConstants& law = changed.physics;
        if (std::isfinite(law.gravity)) {
            law.gravity = std::min(law.gravity, most_gravity);
        }
        if (std::isfinite(law.rest_threshold)) {
            law.rest_threshold = std::min(law.rest_threshold, most_threshold);
        }
        return engine_.configure(changed).has_value();
    }

    bool advance() {
        const bool steps_all = integrator_ == Integrator::semi_implicit_euler_fixed;
        const Ticks longest = steps_all ? 60 * ticks_per_second : never / 1000;
        const std::array<Ticks, 6> spans{-frame, 0, 1, frame, ticks_per_second, longest};
        const unsigned kind = below(60);
        const Ticks now = now_ + spans[kind < spans.size() ? kind : 3];
        now_ = std::max(now_, now);
        engine_.advance(now);
        engine_.advance_held(hand_);
        return true;
    }

    bool verb() {
        const PetId id = pet();
        const unsigned verb = below(verbs);
        switch (verb) {
            case 0: {
                const auto made = engine_.spawn({.at = numbers(), .velocity = numbers()});
                if (made) {
                    ids_.push_back(*made);
                }
                return made.has_value();
            }
            case 1:
                return engine_.fling(id, numbers()).has_value();
            case 2:
                return engine_.push(id, numbers()).has_value();
            case 3:
                return engine_.move_to(id, numbers()).has_value();
            case 4:
                return engine_.stop(id).has_value();
            case 5:
                return engine_.reset(id).has_value();
            case 6:
                return below(8) != 0 || engine_.remove(id).has_value();
            case 7:
            case 8:
                return hold(id, verb);
            case 9:
                return configure();
            case 10:
                return engine_.configure(settings()).has_value();
            default:
                return advance();
        }
    }

    void check() {
        engine_.for_each([](PetId, const Pet& pet) {
            REQUIRE(is_finite(pet.position()));
            REQUIRE(is_finite(pet.velocity()));
            if (pet.motion != Motion::held) {
                REQUIRE(pet.position().x >= hostile_room.x);
                REQUIRE(pet.position().y >= hostile_room.y);
                REQUIRE(pet.position().x <= hostile_room.right() - box.width);
                REQUIRE(pet.position().y <= hostile_room.bottom() - box.height);
            }
        });
        std::size_t bounces = 0;
        for (const Event& event : engine_.take_events()) {
            bounces += event.kind == EventKind::bounce ? 1 : 0;
        }
        REQUIRE(bounces <= most_bounces() * engine_.size());
    }

    // Of one pet in one frame.
    std::size_t most_bounces() const {
        switch (integrator_) {
            case Integrator::event_driven:
                return Trajectory::most_events;
            case Integrator::exponential_swept:
            case Integrator::stormer_verlet:
                return most_contacts_in_step;
            case Integrator::rk45:
                return static_cast<std::size_t>(RungeKuttaSettings{}.most_trials);
            case Integrator::semi_implicit_euler_fixed:
                // A wall and a level in each step.
                return 2 * static_cast<std::size_t>(60 * EngineSettings{}.fixed_rate);
            case Integrator::semi_implicit_euler:
                break;
        }
        return 2;
    }

    Integrator integrator_;
    Engine engine_;
    std::minstd_rand random_{1};
    std::vector<PetId> ids_;
    Ticks now_ = 0;
    Ticks hand_ = 0;
    int refused_ = 0;
};

}  // namespace

TEST_CASE("A10: ten thousand hostile calls leave every pet finite and inside, and refusals no trace"
) {
    for (const Integrator integrator : integrators) {
        CAPTURE(integrator);
        Attacker attacker(integrator);
        for (int i = 0; i < 10'000; ++i) {
            CAPTURE(i);
            attacker.call();
        }
        CHECK(attacker.refused() > 1000);
    }
}
