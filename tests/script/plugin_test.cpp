// SPDX-License-Identifier: MIT
// What plugins have beyond scripts: files of their own, kinds of their own; and wind.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

using namespace hyrax;

namespace {

ScriptSource plugin(std::string text, std::vector<ScriptModule> modules = {}) {
    return {
        .name = "rock",
        .text = std::move(text),
        .version = "1.0.0",
        .file = "main.lua",
        .modules = std::move(modules),
    };
}

std::string errors_with(std::string text, std::vector<ScriptModule> modules) {
    FakeWorld world;
    world.load({plugin(std::move(text), std::move(modules))});
    return world.errors();
}

}  // namespace

TEST_CASE("require runs a module once and answers with what it returns") {
    FakeWorld world;
    world.load({plugin(
        R"(
            local a = require "lib.a"
            print(a.name, require("lib.a") == a, require "nothing", require "hyrax" == hyrax)
        )",
        {{"lib.a", "print('runs', ...) local b = require 'lib.b' return { name = b }"},
         {"lib.b", "return 'b'"},
         {"nothing", ""}}
    )});
    CHECK(world.errors() == "");
    CHECK(world.said() == "runs lib.a\nb true true true\n");
}

TEST_CASE("require finds nothing else, and says so") {
    const std::vector<ScriptModule> modules{{"a", "return 1"}};
    CHECK(errors_with("require 'b'", modules)
              .contains("rock/main.lua:1: require: there is no module 'b' in this plugin"));
    CHECK(errors_with("require '../a'", modules).contains("there is no module"));
    CHECK(errors_with("require 'a'", {}).contains("scripts can require 'hyrax' only"));
    CHECK(errors_with("require 'b'", {{"b", "error('no')"}}).contains("rock/b.lua:1: no"));
    CHECK(errors_with("require 'b'", {{"b", "x ="}}).contains("rock/b.lua:1: unexpected symbol"));
    CHECK(errors_with(
              "require 'a'", {{"a", "require 'b'"}, {"b", "require 'a'"}}
    ).contains("rock/b.lua:1: require: module 'a' is just being loaded, or has failed"));
    CHECK(errors_with("require 'a'", {{"a", "while true do end"}}).contains("stopped until"));
}

TEST_CASE("a module that changes makes the plugin another one") {
    FakeWorld world;
    world.load({plugin("print(require 'a')", {{"a", "return 1"}})});
    world.load({plugin("print(require 'a')", {{"a", "return 1"}})});
    world.load({plugin("print(require 'a')", {{"a", "return 2"}})});
    world.load({plugin("print(require 'a')", {{"a", "return !"}})});
    CHECK(world.said() == "1\n2\n");
    CHECK(world.errors().contains("rock/a.lua:1:"));
}

TEST_CASE("a plugin calls its own kinds without its name, and the others' with it") {
    FakeWorld world;
    world.world.kinds.push_back({.name = "rock/rock", .box = {7, 7}});
    world.world.kinds.push_back({.name = "other/ball", .box = {8, 8}});
    world.load({plugin(R"(
        print(hyrax.spawn{ kind = "rock" }.kind, hyrax.spawn{ kind = "rock/rock" }.kind)
        print(hyrax.spawn{ kind = "other/ball" }.kind, hyrax.spawn().kind)
        print(#hyrax.pets{ kind = "rock" })
        print(pcall(hyrax.spawn, { kind = "ball" }))
    )")});
    CHECK(world.said().starts_with("rock/rock rock/rock\nother/ball hyrax\n2\nfalse"));
    // A script's kinds are those that it names.
    world.load("print(hyrax.spawn{ kind = 'rock' }.kind)", "rock");
    CHECK(world.said().ends_with("\nrock\n"));
}

TEST_CASE("pets of a plugin may leave when it is saved") {
    FakeWorld world;
    ScriptSource source = plugin("hyrax.spawn{}");
    world.load({source});
    source.text += " ";
    world.load({source});
    CHECK(world.world.pets.size() == 2);
    source.keep_pets = false;
    source.text += " ";
    world.load({source});
    CHECK(world.world.pets.size() == 1);
}

TEST_CASE("wind is asked for once for each change, and ends with its script") {
    FakeWorld world;
    world.load(R"(
        hyrax.wind(300) hyrax.wind(300, 0) hyrax.wind(3e9, 4e9) hyrax.wind(0, 0) hyrax.wind()
        hyrax.wind(5, 6)
    )");
    CHECK(world.errors() == "");
    std::vector<command::Wind> winds = world.given<command::Wind>();
    REQUIRE(winds.size() == 4);
    CHECK(winds[0].script == "test.lua");
    CHECK(winds[0].velocity == Vec2{300.0, 0.0});
    CHECK(winds[1].velocity.x == doctest::Approx(12'000.0));
    CHECK(winds[1].velocity.y == doctest::Approx(16'000.0));
    CHECK(winds[2].velocity == Vec2{});
    world.load(std::vector<ScriptSource>{});
    winds = world.given<command::Wind>();
    REQUIRE(winds.size() == 5);
    CHECK(winds[4].velocity == Vec2{});
    CHECK(errors_of("hyrax.wind('left')").contains("hyrax.wind: vx must be a number"));
    CHECK(errors_of("hyrax.wind(0/0)").contains("hyrax.wind: vx must be"));
}

TEST_CASE("wind ends with a script that is stopped") {
    FakeWorld world;
    world.load("hyrax.wind(300) hyrax.after(1, function() while true do end end)");
    world.skip(2.0);
    const std::vector<command::Wind> winds = world.given<command::Wind>();
    REQUIRE(winds.size() == 2);
    CHECK(winds[1].velocity == Vec2{});
}
