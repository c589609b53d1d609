// SPDX-License-Identifier: MIT
// Events: what handlers are given, who is asked, how they end.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

using namespace hyrax;

TEST_CASE("every event reaches its handlers with what it tells") {
    FakeWorld world;
    const PetKey pet = world.add_pet({.tag = "x"});
    world.load(R"(
        for _, name in ipairs{ "spawn", "remove", "grab", "throw", "bounce", "land", "click",
                               "monitors" } do
            hyrax.on(name, function(pet, ...) print(name, pet and pet.tag, ...) end)
        end
    )");
    for (const EventKind kind :
         {EventKind::spawn,
          EventKind::remove,
          EventKind::grab,
          EventKind::throw_pet,
          EventKind::bounce,
          EventKind::land,
          EventKind::click,
          EventKind::monitors}) {
        CHECK(world.listens(kind));
    }
    world.happens({.kind = EventKind::spawn}, pet);
    world.happens({.kind = EventKind::grab}, pet);
    world.happens({.kind = EventKind::throw_pet, .velocity = {1, -2}}, pet);
    world.happens({.kind = EventKind::bounce, .side = Side::left, .speed = 5.5}, pet);
    world.happens({.kind = EventKind::land, .speed = 7.5}, pet);
    world.happens({.kind = EventKind::click, .button = Button::middle}, pet);
    world.happens({.kind = EventKind::monitors}, 0);
    world.run();
    world.take_away(pet);
    world.run();
    CHECK(world.errors() == "");
    CHECK(
        world.said() == "spawn x\ngrab x\nthrow x 1.0 -2.0\nbounce x left 5.5\nland x 7.5\n"
                        "click x middle\nmonitors nil\nremove x\n"
    );
}

TEST_CASE("nobody is asked who does not listen") {
    FakeWorld world;
    const PetKey pet = world.add_pet();
    world.load("hyrax.on('land', function() print('land') end)");
    CHECK(world.listens(EventKind::land));
    CHECK_FALSE(world.listens(EventKind::bounce));
    CHECK_FALSE(world.listens(EventKind::remove));
    world.happens({.kind = EventKind::bounce}, pet);
    world.run();
    CHECK(world.said() == "");
}

TEST_CASE("ready comes after all main chunks") {
    FakeWorld world;
    world.load({
        {"a.lua", "print('a') hyrax.on('ready', function() print('a ready') end)"},
        {"b.lua", "print('b') hyrax.on('ready', function() print('b ready') end)"},
    });
    world.play(0.1);
    CHECK(world.said() == "a\nb\na ready\nb ready\n");
    CHECK(world.last.next_wake == never);
}

TEST_CASE("tick comes at most 60 times a second and tells the time since the last one") {
    // At 60 frames a second, at 144 and at 240.
    for (const int frames : {60, 144, 240}) {
        CAPTURE(frames);
        FakeWorld world;
        world.load(
            "n, sum = 0, 0 "
            "hyrax.on('tick', function(dt) n = n + 1 sum = sum + dt end) "
            "hyrax.on('click', function() print(n >= 59 and n <= 60, sum > 0.97, sum < 1.01) end)"
        );
        CHECK(world.last.next_wake <= world.world.now + ticks_per_second / 60);
        for (int i = 0; i < frames; ++i) {
            world.skip(1.0 / frames);
        }
        world.happens({.kind = EventKind::click}, world.add_pet());
        world.run();
        CHECK(world.said() == "true true true\n");
    }
}

TEST_CASE("a handler of one pet hears of that pet alone and ends with it") {
    FakeWorld world;
    const PetKey first = world.add_pet();
    const PetKey second = world.add_pet();
    world.load(R"(
        local pet = hyrax.pets{ all = true }[1]
        pet:on("land", function(p, speed) print("land", p == pet, speed) end)
        pet:on("remove", function(p) print("remove", p == pet, p.valid) end)
    )");
    world.happens({.kind = EventKind::land, .speed = 1.5}, first);
    world.happens({.kind = EventKind::land, .speed = 2.5}, second);
    world.run();
    world.take_away(first);
    world.run();
    CHECK(world.errors() == "");
    CHECK(world.said() == "land true 1.5\nremove true false\n");
    CHECK(world.last.listening == EventMask{});
}

TEST_CASE("subscriptions end when they are cancelled, also by themselves") {
    FakeWorld world;
    const PetKey pet = world.add_pet();
    world.load(R"(
        local second
        local first = hyrax.on("click", function() print("first") second:cancel() end)
        second = hyrax.on("click", function() print("second") end)
        local once
        once = hyrax.on("click", function() print("once") once:cancel() once:cancel() end)
    )");
    world.happens({.kind = EventKind::click}, pet);
    world.happens({.kind = EventKind::click}, pet);
    world.run();
    CHECK(world.errors() == "");
    CHECK(world.said() == "first\nonce\nfirst\n");
}

TEST_CASE("a handler that is made by an event does not hear that event") {
    FakeWorld world;
    const PetKey pet = world.add_pet();
    world.load("hyrax.on('click', function() hyrax.on('click', function() print('x') end) end)");
    world.happens({.kind = EventKind::click}, pet);
    world.run();
    CHECK(world.said() == "");
}

TEST_CASE("events of a pet that is already gone are left out") {
    FakeWorld world;
    world.load("hyrax.on('bounce', function() print('bounce') end)");
    world.happens({.kind = EventKind::bounce}, 77);
    world.run();
    CHECK(world.said() == "");
}

TEST_CASE("wait_for answers with what the event tells") {
    FakeWorld world;
    const PetKey pet = world.add_pet();
    world.load(R"(
        local pet = hyrax.pets{ all = true }[1]
        hyrax.task(function() print("bounce", hyrax.wait_for(pet, "bounce")) end)
        hyrax.task(function() print("grab", hyrax.wait_for(pet, "grab", 10)) end)
        hyrax.task(function() print("timeout", hyrax.wait_for(pet, "click", 0.5)) end)
        hyrax.task(function() print("gone", hyrax.wait_for(pet, "throw")) end)
        hyrax.task(function() print("remove", hyrax.wait_for(pet, "remove")) end)
    )");
    CHECK(world.listens(EventKind::bounce));
    CHECK(world.listens(EventKind::remove));
    world.happens({.kind = EventKind::bounce, .side = Side::top, .speed = 3.5}, pet);
    world.happens({.kind = EventKind::grab}, pet);
    world.play(1.0);
    world.take_away(pet);
    world.run();
    CHECK(world.errors() == "");
    CHECK(world.said() == "bounce top 3.5\ngrab true\ntimeout nil\nremove true\ngone nil\n");
    CHECK(world.last.listening == EventMask{});
    CHECK(world.last.next_wake == never);
}

TEST_CASE("a pet that goes ends every wait for it") {
    FakeWorld world;
    const PetKey pet = world.add_pet();
    world.load("print(hyrax.wait_for(hyrax.pets{ all = true }[1], 'bounce'))");
    CHECK(world.listens(EventKind::remove));
    world.take_away(pet);
    world.run();
    CHECK(world.said() == "nil\n");
}

TEST_CASE("wrong events and functions are named") {
    CHECK(errors_of("hyrax.on('bounse', print)").contains("did you mean 'bounce'?"));
    CHECK(errors_of("hyrax.on(5, print)").contains("hyrax.on: event must be a string, got number"));
    CHECK(errors_of("hyrax.on('land')").contains("hyrax.on: fn must be a function, got no value"));
    const std::string pet = "local p = hyrax.spawn() ";
    CHECK(errors_of(pet + "p:on('tick', print)").contains("'tick' is not about a pet"));
    CHECK(errors_of(pet + "p:on('land', 1)").contains("pet:on: fn must be a function"));
    CHECK(errors_of(pet + "hyrax.wait_for(p, 'ready')").contains("'ready' is not about a pet"));
    CHECK(errors_of("hyrax.wait_for(5, 'land')").contains("expected a pet, got number"));
    CHECK(errors_of("hyrax.on('land', print).cancel(5)").contains("expected a subscription"));
}
