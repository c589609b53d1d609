// SPDX-License-Identifier: MIT
// Every piece of Lua in the documentation runs without an error.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

using namespace hyrax;

namespace {

struct Block {
    int line = 0;
    std::string text;
};

std::vector<Block> blocks_of(const std::string& name) {
    std::ifstream file(HYRAX_SOURCE_DIR "/" + name);
    REQUIRE(file.good());
    std::vector<Block> blocks;
    bool inside = false;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        if (!inside && line == "```lua") {
            inside = true;
            blocks.push_back({number + 1, ""});
        } else if (line == "```") {
            inside = false;
        } else if (inside) {
            blocks.back().text += line + "\n";
        }
    }
    return blocks;
}

// Everything happens to every pet.
void disturb(FakeWorld& world) {
    const std::vector<PetView> pets = world.world.pets;
    for (const PetView& pet : pets) {
        for (const Button button : {Button::left, Button::middle, Button::right}) {
            world.happens({.kind = EventKind::click, .button = button}, pet.key);
        }
        world.happens({.kind = EventKind::grab}, pet.key);
        world.happens({.kind = EventKind::throw_pet, .velocity = {300, -300}}, pet.key);
        world.happens({.kind = EventKind::land, .speed = 700}, pet.key);
        world.happens({.kind = EventKind::bounce, .side = Side::left, .speed = 700}, pet.key);
        world.happens_between(
            {.kind = EventKind::collide, .speed = 700}, pet.key, pets.front().key
        );
    }
    for (const command::Hotkey& hotkey : world.given<command::Hotkey>()) {
        world.world.pressed_hotkeys = {{"test.lua", hotkey.id}};
    }
    world.run();
    world.world.pressed_hotkeys = {};
}

}  // namespace

TEST_CASE("the scripts of the guide run as they stand") {
    const std::vector<Block> blocks = blocks_of("docs/scripting.md");
    CHECK(blocks.size() >= 19);
    std::size_t cases = 0;
    for (const Block& block : blocks) {
        CAPTURE(block.line);
        CAPTURE(block.text);
        FakeWorld world;
        world.world.cursor = Vec2{5.0, 5.0};
        world.load({{.name = "test.lua", .text = block.text, .testing = true}});
        world.add_pet();
        for (int i = 0; i < 5; ++i) {
            world.play(6.0);
            disturb(world);
        }
        if (!world.world.pets.empty()) {
            world.take_away(world.world.pets.front().key);
        }
        world.play(6.0);
        world.load("");
        CHECK(world.errors() == "");
        for (const ScriptTest& test : world.tests) {
            CHECK(test.problem == "");
            ++cases;
        }
        const bool does_something = !world.commands.empty() || !world.log.empty() ||
                                    !world.tests.empty() || block.text.contains("hyrax.on");
        CHECK(does_something);
    }
    CHECK(cases >= 2);
}
