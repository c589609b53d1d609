// SPDX-License-Identifier: MIT
// Random programs against the real engine; `./dev fuzz` plays many.
#include "daemon/core/engine.h"
#include "daemon/core/script_bridge.h"
#include "daemon/script/script_host.h"
#include "tests/script/random_program.h"
#include "tests/support/fuzzing.h"

#include <doctest/doctest.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace hyrax;

namespace {

constexpr Ticks frame = ticks_per_second / 60;

Monitor monitor(Rect bounds) {
    return {.bounds = bounds, .work = bounds, .primary = true, .name = {}};
}

// Passes everything on and remembers what must never be said.
class WatchingHost final : public ScriptHost {
public:
    explicit WatchingHost(bool& broken)
        : host_(make_script_host({.load_units = 1'000'000, .callback_units = 200'000})),
          broken_(broken) {}
    void load(std::vector<ScriptSource> sources) override { host_->load(std::move(sources)); }
    ScriptOutput run(const ScriptWorld& world, std::span<const ScriptEvent> events) override {
        ScriptOutput output = host_->run(world, events);
        for (const ScriptLog& line : output.log) {
            broken_ = broken_ || line.text.contains("internal error");
        }
        return output;
    }

private:
    std::unique_ptr<ScriptHost> host_;
    bool& broken_;
};

class Play {
public:
    explicit Play(std::uint64_t seed)
        : random_(seed),
          engine_(
              {{.name = "hyrax", .box = {100, 80}, .animations = {"idle", "walk"}},
               {.name = "rock", .box = {40, 40}}},
              {},
              1
          ),
          bridge_(std::make_unique<WatchingHost>(broken_)) {
        engine_.set_arena(Arena(monitors_, FloorEdge::work_area));
        static_cast<void>(engine_.spawn({}));
        load(seed);
    }

    void run(int frames) {
        for (int i = 0; i < frames; ++i) {
            disturb();
            now_ += frame;
            static_cast<void>(engine_.advance_held(now_));
            engine_.advance(now_);
            bridge_.run(engine_, monitors_, now_);
            static_cast<void>(bridge_.take_wishes());
            check();
        }
        bridge_.end(engine_, monitors_, {now_, now_}, {});
        check();
    }

private:
    bool chance(unsigned percent) { return random_() % 100 < percent; }

    void load(std::uint64_t seed) {
        ScriptSource one{.name = "one.lua", .text = random_program(seed)};
        ScriptSource two{.name = "two.lua", .text = random_program(seed + 1'000'003)};
        one.permissions = {script_permissions.begin(), script_permissions.end()};
        one.testing = seed % 3 == 0;
        bridge_.load({std::move(one), std::move(two)});
    }

    PetId some_pet() {
        std::vector<PetId> all;
        engine_.for_each([&all](PetId id, const Pet&) { all.push_back(id); });
        return all.empty() ? PetId{} : all[random_() % all.size()];
    }

    // What the user and the machine do meanwhile.
    void disturb() {
        const PetId pet = some_pet();
        if (chance(4) && !held_) {
            held_ = engine_.grab(pet, now_) ? std::optional(pet) : std::nullopt;
        } else if (held_ && engine_.find(*held_) == nullptr) {
            held_.reset();
        } else if (held_ && chance(20)) {
            CHECK(engine_.let_go(*held_, now_, 5'000.0));
            held_.reset();
        } else if (held_) {
            CHECK(engine_.carry(*held_, {static_cast<double>(random_() % 900), 100.0}, now_));
        }
        if (chance(5)) {
            engine_.click(pet, Button::left);
        }
        if (chance(1)) {
            static_cast<void>(engine_.remove(pet));
        }
        if (chance(1)) {
            const int width = 400 + static_cast<int>(random_() % 900);
            monitors_ = {monitor({0, 0, width, 700}), monitor({width, 100, 500, 900})};
            engine_.set_arena(Arena(monitors_, FloorEdge::work_area));
        }
        if (chance(1)) {
            load(random_() % 1'000);
        }
    }

    void check() {
        CHECK_FALSE(broken_);
        CHECK(engine_.size() <= engine_.settings().max_pets);
        std::size_t awake = 0;
        engine_.for_each([&](PetId id, const Pet& pet) {
            const Vec2 at = pet.position();
            const Vec2 v = pet.velocity();
            CHECK(std::isfinite(at.x));
            CHECK(std::isfinite(at.y));
            CHECK(std::hypot(v.x, v.y) < 1e6);
            CHECK(pet.scale >= least_scale);
            CHECK(pet.scale <= most_scale);
            CHECK((pet.motion == Motion::walking ? pet.walk.has_value() : true));
            awake += pet.awake ? 1U : 0U;
            if (pet.motion != Motion::held) {
                const FreeSpace space = engine_.arena().space_for(engine_.box_of(pet));
                const Vec2 corner = at + space.overhang();
                const Vec2 off = space.nearest(corner) - corner;
                CHECK_MESSAGE(std::hypot(off.x, off.y) < 1e-6, "pet ", id.index, " is outside");
            }
        });
        CHECK(awake == engine_.awake_count());
    }

    std::mt19937_64 random_;
    bool broken_ = false;
    std::vector<Monitor> monitors_{monitor({0, 0, 1280, 800})};
    Engine engine_;
    ScriptBridge bridge_;
    std::optional<PetId> held_;
    Ticks now_ = 0;
};

}  // namespace

TEST_CASE("random programs break nothing") {
    const auto level = spdlog::get_level();
    spdlog::set_level(spdlog::level::off);
    fuzz(60, [](std::uint64_t seed) { Play(seed).run(90); });
    spdlog::set_level(level);
}

TEST_CASE("random programs do things, right and wrong ones") {
    const std::string all = [] {
        std::string text;
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
            text += random_program(seed);
        }
        return text;
    }();
    for (const char* const piece :
         {"walk_to(",
          "play(",
          "say(",
          ".scale = ",
          "hyrax.store.set",
          "wait_for",
          "0/0",
          "'collide'",
          "'unload'",
          "sub():cancel()",
          "hotkey",
          "table.sort"}) {
        CHECK_MESSAGE(all.contains(piece), piece);
    }
    CHECK(random_program(5) == random_program(5));
}
