// SPDX-License-Identifier: MIT
// Timers, waits and tasks on a virtual clock.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

using namespace hyrax;

TEST_CASE("after fires once, every again and again, in the order of their times") {
    FakeWorld world;
    world.load(R"(
        hyrax.after(0.5, function() print("after", hyrax.now()) end)
        local n = 0
        local timer
        timer = hyrax.every(0.25, function()
            n = n + 1
            print("every", n)
            if n == 3 then timer:cancel() end
        end)
    )");
    CHECK(world.last.next_wake == world.world.now + from_seconds(0.25));
    for (int i = 0; i < 8; ++i) {
        world.skip(0.25);
    }
    CHECK(world.errors() == "");
    CHECK(world.said() == "every 1\nafter 0.5\nevery 2\nevery 3\n");
    CHECK(world.last.next_wake == never);
}

TEST_CASE("a fast timer keeps its pace at 60 frames a second, and after a pause there is no burst"
) {
    FakeWorld world;
    world.load("n = 0 hyrax.every(1 / 120, function() n = n + 1 end) "
               "hyrax.every(1, function() print(n) n = 0 end)");
    world.play(1.02);
    CHECK(world.said() == "120\n");
    world.skip(3600.0);
    CHECK(world.said() == "120\n3\n");  // one for the pause, and two frames' worth before it
}

TEST_CASE("a script that waits for nothing costs no wake-up") {
    FakeWorld world;
    world.load("hyrax.on('click', function() end)");
    CHECK(world.last.next_wake == never);
    world.load("hyrax.after(5, print)");
    CHECK(world.last.next_wake == world.world.now + 5 * ticks_per_second);
    world.load(std::vector<ScriptSource>{});
    CHECK(world.last.next_wake == never);
    CHECK(world.last.listening == EventMask{});
}

TEST_CASE("wait works in main chunks, handlers, timers, tasks and coroutines of the script") {
    FakeWorld world;
    world.load(R"(
        hyrax.after(0, function() hyrax.wait(0.1) print("timer") end)
        hyrax.task(function(a, b) hyrax.wait(0.2) print("task", a, b) end, 1, "two")
        hyrax.on("ready", function() hyrax.wait(0.3) print("handler") end)
        local inner = coroutine.wrap(function(a)
            local waited = hyrax.wait(0.4)
            print("wrapped", a, waited >= 0.4)
            local b = coroutine.yield("yielded")
            hyrax.wait(0.1)
            print("again", b)
            return "end"
        end)
        print(inner("a"))
        print(inner("b"))
        local ok, value = coroutine.resume(coroutine.create(function()
            return select(2, pcall(function() hyrax.wait(0.1) return "deep" end))
        end))
        print(ok, value)
        print("main", hyrax.wait(0.1) >= 0.1)
    )");
    world.play(2.0);
    CHECK(world.errors() == "");
    CHECK(
        world.said() == "timer\ntask 1 two\nhandler\nwrapped a true\nyielded\nagain b\nend\n"
                        "true deep\nmain true\n"
    );
    CHECK(world.last.next_wake == never);
}

TEST_CASE("wait is refused where a coroutine cannot stop") {
    const std::string refused = "cannot wait";
    CHECK(errors_of("table.sort({ 2, 1 }, function() hyrax.wait(1) end)").contains(refused));
    CHECK(errors_of("('x'):gsub('x', function() hyrax.wait(1) end)").contains(refused));
    FakeWorld world;
    world.load(R"(
        local t = setmetatable({}, { __index = function()
            return coroutine.wrap(function() hyrax.wait(1) end)()
        end })
        print(t.x)
    )");
    // Lua lets metamethods of Lua functions yield: this one may wait, or say that it cannot.
    world.play(2.0);
    CHECK((world.said() == "nil\n" || world.errors().contains(refused)));

    FakeWorld inside;
    inside.load(R"(
        local co = coroutine.create(function() hyrax.wait(1) end)
        table.sort({ 2, 1 }, function(a, b) print(coroutine.resume(co)) return a < b end)
    )");
    CHECK(inside.said().contains(refused));
    CHECK(inside.last.next_wake == never);
}

TEST_CASE("nobody else can resume or close a coroutine that waits") {
    FakeWorld world;
    world.load(R"(
        local inner = coroutine.create(function() hyrax.wait(1) print("rested") end)
        local outer
        hyrax.task(function() outer = coroutine.running() coroutine.resume(inner) print("through") end)
        print(coroutine.status(inner), coroutine.resume(inner))
        print(coroutine.resume(outer))
        print(pcall(coroutine.close, inner))
        print(pcall(coroutine.close, outer))
        print(pcall(coroutine.yield))
    )");
    world.play(1.5);
    CHECK(world.errors() == "");
    CHECK(world.said().starts_with("suspended false cannot resume a coroutine"));
    CHECK(world.said().contains("false cannot close a coroutine that is in hyrax.wait\n"));
    CHECK(world.said().contains("false attempt to yield outside a coroutine"));
    CHECK(world.said().ends_with("rested\nthrough\n"));
}

TEST_CASE("no wait is so short that the daemon could not sleep") {
    FakeWorld world;
    world.load("n = 0 hyrax.task(function() while true do hyrax.wait(0) n = n + 1 end end) "
               "hyrax.on('click', function() print(n) end) "
               "local function again() hyrax.after(0, again) end again()");
    for (int i = 0; i < 10; ++i) {
        CHECK(world.last.next_wake >= world.world.now + ticks_per_second / 120);
        world.run();
    }
    const PetKey pet = world.add_pet();
    world.happens({.kind = EventKind::click}, pet);
    world.run();
    CHECK(world.said() == "0\n");
}

TEST_CASE("tasks start at once and report their own errors") {
    FakeWorld world;
    world.load("hyrax.task(function() print('in') error('lost') end) print('after')");
    CHECK(world.said() == "in\nafter\n");
    CHECK(world.errors().starts_with("test.lua:1: lost\n"));
}

TEST_CASE("now is constant in a callback and counts from loading") {
    FakeWorld world;
    world.load("print(hyrax.now()) hyrax.after(1.5, function() print(hyrax.now()) end)");
    world.skip(2.0);
    CHECK(world.said() == "0.0\n2.0\n");
}

TEST_CASE("wrong times are named") {
    CHECK(errors_of("hyrax.every(0/0, print)").contains("hyrax.every: seconds must be a finite"));
    CHECK(errors_of("hyrax.every(0.001, print)").contains("must be at least 1/120"));
    CHECK(errors_of("hyrax.every(1, nil)").contains("hyrax.every: fn must be a function, got nil"));
    CHECK(errors_of("hyrax.after(-1, print)").contains("hyrax.after: seconds must be from 0 to"));
    CHECK(errors_of("hyrax.after(1e300, print)").contains("hyrax.after: seconds must be from 0 to")
    );
    CHECK(errors_of("hyrax.wait('1')").contains("hyrax.wait: seconds must be a number, got string")
    );
    CHECK(errors_of("hyrax.task(1)").contains("hyrax.task: fn must be a function"));
    CHECK(errors_of("hyrax.every(1 / 120, print)") == "");
}
