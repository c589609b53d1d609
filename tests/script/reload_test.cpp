// SPDX-License-Identifier: MIT
// Scripts that are saved while they run: the new text is tried beside the old one.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace hyrax;

namespace {

constexpr char counting[] = R"(
    local n = 0
    hyrax.spawn{ tag = "first" }
    hyrax.every(1, function() n = n + 1 print("first", n) end)
)";

std::size_t spawned(const FakeWorld& world) {
    return world.given<command::Spawn>().size();
}

}  // namespace

TEST_CASE("a broken save says why, and what ran before goes on as if nothing had been") {
    const char* broken = nullptr;
    const char* why = nullptr;
    SUBCASE("it is no Lua") {
        broken = "hyrax.spawn( hyrax.every";
        why = "test.lua:1: ";
    }
    SUBCASE("it fails half way") {
        broken = "hyrax.spawn() hyrax.every(0.1, print) hyrax.hotkey('ctrl+h', 'x', print) x.y = 1";
        why = "test.lua:1: attempt to index a nil value (global 'x')";
    }
    SUBCASE("it never ends") {
        broken = "hyrax.spawn() while true do end";
        why = "work units";
    }
    SUBCASE("it needs too much memory") {
        broken = "x = ('x'):rep(2 ^ 21)";
        why = "memory";
    }
    FakeWorld world;
    world.load(counting);
    world.play(1.5);
    world.load(broken);
    CHECK(world.errors().contains(why));
    CHECK(world.lines(LogLevel::warning).contains("goes on"));
    world.play(1.0);
    CHECK(world.said() == "first 1\nfirst 2\n");
    CHECK(spawned(world) == 1);
    CHECK(world.given<command::Hotkey>().empty());
    CHECK(world.last.ended == std::vector<std::uint32_t>{0});

    // Another file is saved: this text is not tried again.
    const std::size_t errors = world.errors().size();
    world.load({{"test.lua", broken}, {"other.lua", "print 'other'"}});
    CHECK(world.errors().size() == errors);
    // It is mended.
    world.load({{"test.lua", "print 'mended'"}, {"other.lua", "print 'other'"}});
    world.play(2.0);
    CHECK(world.said().ends_with("other\nmended\n"));
    CHECK(world.last.ended.empty());
}

TEST_CASE("a good save takes over at once: pets and the store stay, all else begins anew") {
    FakeWorld world;
    world.load(R"(
        hyrax.spawn{ tag = "kept" }
        hyrax.every(0.1, function() hyrax.store.set("n", hyrax.store.get("n", 0) + 1) end)
        hyrax.on("unload", function(why) hyrax.store.set("why", why) end)
    )");
    world.play(1.05);
    world.load(R"(
        print(hyrax.store.get("n"), hyrax.store.get("why"), #hyrax.pets{ tag = "kept" })
        hyrax.spawn{ tag = "new" }
        hyrax.on("ready", function() print("ready", #hyrax.pets()) end)
    )");
    world.play(1.0);
    CHECK(world.said() == "10 reload 1\nready 2\n");
    CHECK(spawned(world) == 2);
    CHECK(world.errors() == "");
}

TEST_CASE("who is not changed is not touched") {
    FakeWorld world;
    world.load({{"a.lua", counting}, {"b.lua", "print 'b'"}});
    world.play(1.5);
    world.load({{"b.lua", "print 'new b'"}, {"a.lua", counting}});
    world.play(1.0);
    CHECK(world.said() == "b\nfirst 1\nnew b\nfirst 2\n");
    CHECK(spawned(world) == 1);
}

TEST_CASE("all texts are new ones after a change of the limits, or when that is asked for") {
    for (const bool limits : {false, true}) {
        FakeWorld world;
        world.load(counting);
        world.play(1.5);
        if (limits) {
            world.set_limits({.timers = 3});
        } else {
            world.renew();
        }
        world.load(counting);
        world.play(1.5);
        CHECK(world.said() == "first 1\nfirst 1\n");
        CHECK(spawned(world) == 2);
    }
}

TEST_CASE("a script that fails as it is first loaded leaves nothing behind") {
    FakeWorld world;
    world.load("hyrax.spawn() hyrax.every(0.1, print) hyrax.on('ready', print) x.y = 1");
    world.play(1.0);
    CHECK(spawned(world) == 0);
    CHECK(world.said() == "");
    CHECK(world.last.ended == std::vector<std::uint32_t>{0});
    CHECK(world.last.next_wake == never);
}
