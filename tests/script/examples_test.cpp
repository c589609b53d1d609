// SPDX-License-Identifier: MIT
// The shipped examples do what they promise, without an error, on any arena.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

using namespace hyrax;

namespace {

std::string example(const std::string& name) {
    std::ifstream file(HYRAX_SOURCE_DIR "/scripts/examples/" + name, std::ios::binary);
    REQUIRE(file.good());
    return {std::istreambuf_iterator<char>(file), {}};
}

Monitor monitor(Rect bounds, bool primary = true) {
    return {.bounds = bounds, .work = bounds, .primary = primary, .name = ""};
}

std::vector<std::vector<Monitor>> arenas() {
    return {
        FakeWorld().world.monitors,
        {monitor({0, 0, 640, 480})},
        {monitor({-3840, -2160, 3840, 2160}), monitor({0, 0, 800, 600}, false)},
        {},
    };
}

// Plays the example for a minute on each arena and hands the world to `look`.
template <typename Look>
void play(const std::string& name, Look look) {
    for (const std::vector<Monitor>& monitors : arenas()) {
        FakeWorld world;
        if (!monitors.empty()) {
            world.world.monitors = monitors;
        }
        world.load(example(name), name);
        if (monitors.empty()) {
            world.world.monitors.clear();
            world.happens({.kind = EventKind::monitors}, 0);
            world.run();
            world.world.monitors = FakeWorld().world.monitors;
            world.happens({.kind = EventKind::monitors}, 0);
        }
        world.add_pet();
        world.play(60.0);
        CHECK(world.errors() == "");
        look(world);
    }
}

}  // namespace

TEST_CASE("the fountain spouts and stays bounded") {
    play("fountain.lua", [](const FakeWorld& world) {
        CHECK(world.given<command::Spawn>().size() > 150);
        CHECK(world.world.pets.size() <= 21);
        CHECK(world.world.pets.size() > 15);
    });
}

TEST_CASE("the juggler throws from hand to hand and keeps few in the air") {
    play("juggling.lua", [](const FakeWorld& world) {
        CHECK(world.given<command::Fling>().size() > 60);
        CHECK(world.world.pets.size() == 4);
        const auto idle = std::ranges::count(world.world.pets, "idle", &PetView::state);
        CHECK(idle == 1);  // the one that is not the juggler's
    });
}

TEST_CASE("a juggled hyrax comes down at the other hand") {
    FakeWorld world;
    world.load(example("juggling.lua"), "juggling.lua");
    const double middle = 1920 / 2.0;
    int catches = 0;
    int swapped = 0;
    double last_side = 0.0;
    for (int i = 0; i < 600; ++i) {
        world.play(1.0 / 59.0);
        const PetKey ball = world.world.pets.front().key;
        for (const ScriptCommand& command : world.last.commands) {
            const auto* const fling = std::get_if<command::Fling>(&command);
            if (fling != nullptr && fling->pet == ball) {
                const double x = world.find(ball)->position.x + 50 - middle;
                CHECK(std::abs(std::abs(x) - 0.2 * 1920) < 60);
                swapped += last_side * x < 0 ? 1 : 0;
                last_side = x;
                ++catches;
            }
        }
    }
    CHECK(catches >= 5);
    CHECK(swapped == catches - 1);
}

TEST_CASE("the earth quakes for everybody but those in a hand") {
    play("earthquake.lua", [](const FakeWorld& world) {
        CHECK(world.given<command::Push>().size() > 20);
        CHECK(world.said().contains("earthquake of magnitude"));
    });
    FakeWorld world;
    world.load(example("earthquake.lua"), "earthquake.lua");
    const PetKey held = world.add_pet({.state = "held"});
    world.play(60.0);
    CHECK(world.given<command::Push>().empty());
    CHECK(world.find(held) != nullptr);
}
