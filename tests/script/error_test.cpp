// SPDX-License-Identifier: MIT
// Errors, limits and the log: what people who write scripts read.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace hyrax;

TEST_CASE("an error names file and line, then the calls that led there") {
    FakeWorld world;
    world.load(
        "local function inner()\n  error('boom')\nend\n"
        "local function outer()\n  inner()\nend\nouter()\n",
        "fountain.lua"
    );
    CHECK(
        world.errors() == "fountain.lua:2: boom\n"
                          "    in global 'error'\n"
                          "    fountain.lua:2: in upvalue 'inner'\n"
                          "    fountain.lua:5: in local 'outer'\n"
                          "    fountain.lua:7: in main chunk\n"
    );
    CHECK(world.log.front().script == "fountain.lua");
}

TEST_CASE("syntax errors name file and line") {
    CHECK(errors_of("local x = 1\nlocal = 2\n").starts_with("test.lua:2: "));
    CHECK(errors_of("\xEF\xBB\xBFlocal x = 1") == "");  // what Notepad puts at the front
    CHECK(errors_of("\x1BLua").contains("binary chunk"));
}

TEST_CASE("errors in handlers, timers and waiting coroutines are reported and nothing else stops") {
    FakeWorld world;
    const PetKey pet = world.add_pet();
    world.load({
        {"bad.lua",
         "hyrax.on('click', function() error('in handler') end)\n"
         "hyrax.after(0.1, function() error('in timer') end)\n"
         "hyrax.wait(0.2) error('in wait')"},
        {"good.lua", "hyrax.on('click', function() print('click') end)"},
    });
    world.happens({.kind = EventKind::click}, pet);
    world.play(0.3);
    CHECK(world.errors().contains("bad.lua:1: in handler\n"));
    CHECK(world.errors().contains("bad.lua:2: in timer\n"));
    CHECK(world.errors().contains("bad.lua:3: in wait\n"));
    CHECK(world.said() == "click\n");
}

TEST_CASE("what is to be closed is closed after an error") {
    FakeWorld world;
    world.load("local x <close> = setmetatable({}, { __close = function() print('closed') end }) "
               "hyrax.wait(0.1) error('x')");
    world.play(0.2);
    CHECK(world.said() == "closed\n");
}

TEST_CASE("what is raised need not be a text") {
    CHECK(errors_of("error({ code = 5 })").starts_with("test.lua:1: the error object is a table"));
    CHECK(errors_of("error(nil)").contains("the error object is a nil value"));
    CHECK(errors_of("error(42)").starts_with("test.lua:1: 42\n"));
    CHECK(errors_of("error('no place', 0)").starts_with("test.lua:1: no place\n"));
    CHECK(errors_of("error(setmetatable({}, { __tostring = function() while true do end end, "
                    "__name = ('x'):rep(1e5) }))")
              .starts_with("test.lua:1: the error object is a table value\n"));
}

TEST_CASE("a huge message is cut and control characters are taken out") {
    const std::string errors = errors_of("error(('\\27[2J\\0\\r\\n\\xff'):rep(80000))");
    const std::string first = errors.substr(0, errors.find('\n'));
    CHECK(first.size() < 1'100);
    CHECK(first.ends_with("..."));
    CHECK(std::ranges::all_of(first, [](char c) { return c >= ' ' && c <= '~'; }));
}

TEST_CASE("the same error is counted, not repeated") {
    FakeWorld world;
    world.load("hyrax.every(1, function() error('again') end)");
    for (int i = 0; i < 100; ++i) {
        world.skip(1.0);
    }
    const std::string errors = world.errors();
    CHECK(std::ranges::count(errors, '\n') == 5);  // with two lines of trace
    CHECK(errors.contains("test.lua:1: again (10 times)\n"));
    CHECK(errors.contains("test.lua:1: again (100 times)\n"));
}

TEST_CASE("20 errors in 10 seconds pause a script until it is loaded again") {
    FakeWorld world;
    const std::string text = "hyrax.every(0.1, function() print('x') error('again') end)";
    world.load(text);
    world.play(5.0);
    CHECK(world.errors().contains("test.lua: paused after 20 errors in 10 s"));
    const std::string said = world.said();
    CHECK(std::ranges::count(said, '\n') == 20);
    CHECK(world.last.next_wake == never);
    world.renew();
    world.load(text);
    CHECK(world.last.next_wake != never);
}

TEST_CASE("the deep end of a recursion is left out of the trace") {
    const std::string errors = errors_of("local function f(n) if n == 0 then error('deep') end "
                                         "return 1 + f(n - 1) end f(100)");
    CHECK(errors.contains("more calls)"));
    CHECK(errors.contains("in main chunk"));
    CHECK(std::ranges::count(errors, '\n') == 14);
}

TEST_CASE("counts have limits, which are ordinary errors") {
    const std::string pets = errors_of("for i = 1, 64 do hyrax.spawn() end print('64') "
                                       "for i = 1, 2 do hyrax.spawn() end");
    CHECK(pets.contains("limit of 64 pets"));
    CHECK(errors_of("for i = 1, 257 do hyrax.after(1, print) end").contains("limit of 256 timers"));
    CHECK(
        errors_of("for i = 1, 257 do hyrax.on('land', print) end").contains("limit of 256 handlers")
    );
    CHECK(errors_of("for i = 1, 64 do hyrax.task(hyrax.wait, 1) end hyrax.wait(1)")
              .contains("limit of 64 waiting coroutines"));
    CHECK(errors_of("local p = hyrax.spawn() for i = 1, 1000 do p:stop() end")
              .contains("limit of 1000 commands"));
    CHECK(
        errors_of("for i = 1, 64 do hyrax.spawn() end for i = 1, 256 do hyrax.after(1, print) end "
                  "for i = 1, 256 do hyrax.on('land', print) end") == ""
    );
}

TEST_CASE("what is cancelled or over no longer counts") {
    FakeWorld world;
    world.load(R"(
        for i = 1, 1000 do hyrax.after(1, print):cancel() hyrax.on("land", print):cancel() end
        for i = 1, 300 do hyrax.spawn():remove() end
    )");
    CHECK(world.errors() == "");
}

TEST_CASE("the commands of one run do not count in the next") {
    FakeWorld world;
    world.load("local p = hyrax.spawn() "
               "hyrax.every(1, function() for i = 1, 900 do p:stop() end end)");
    world.skip(1.0);
    world.skip(1.0);
    CHECK(world.errors() == "");
}

TEST_CASE("print and log write what they are given") {
    FakeWorld world;
    world.load(R"(
        print("a", 1, true, nil, setmetatable({}, { __tostring = function() return "mine" end }))
        hyrax.log.info("%d of %s", 5, "six")
        hyrax.log.info("100 %")
        hyrax.log.warn("careful")
        hyrax.log.error("bad")
        hyrax.log.info(42)
    )");
    CHECK(world.said() == "a 1 true nil mine\n5 of six\n100 %\n42\n");
    CHECK(world.lines(LogLevel::warning) == "careful\n");
    CHECK(world.errors() == "bad\n");
    CHECK(errors_of("hyrax.log.info('%d', 'x')").contains("bad argument #2 to 'string.format'"));
}

TEST_CASE("log lines are limited in length and number") {
    FakeWorld world;
    world.load("print(('\\u{20AC}'):rep(1000)) for i = 1, 500 do print(i) end");
    CHECK(world.log.size() == 100);
    CHECK(world.log.front().text.size() <= 512);
    CHECK(world.log.front().text.ends_with("\u20AC..."));
    world.load("hyrax.every(1, function() print('x') end)");
    world.log.clear();
    world.load("for i = 1, 500 do print(i) end hyrax.every(1, function() print('x') end)");
    world.skip(1.0);
    CHECK(world.lines(LogLevel::warning).contains("400 log lines dropped"));
    CHECK(world.log.size() == 102);
}

TEST_CASE("a poisoned library harms only its own script") {
    FakeWorld world;
    world.load({
        {"bad.lua",
         "string.format = function() error('poisoned') end tostring = nil print = nil "
         "string.rep = nil hyrax.log.info('%s is %d', 'one', 1) hyrax = nil"},
        {"good.lua", "print(('x'):rep(3), tostring(5), string.format('%d', 6))"},
    });
    CHECK(world.errors() == "");
    CHECK(world.said() == "one is 1\nxxx 5 6\n");
}

TEST_CASE("the same scripts in the same world do the same") {
    const auto played = [] {
        FakeWorld world;
        world.load(
            "hyrax.every(0.1, function() local p = hyrax.spawn{ vx = math.random(-500, 500) } "
            "print(p.x, p.vx, math.random()) end)"
        );
        world.play(5.0);
        return world.said();
    };
    CHECK(played() == played());
}
