// SPDX-License-Identifier: MIT
// Hostile scripts: each ends as it must, is named, and harms nobody else.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

#include <chrono>
#include <string>

using namespace hyrax;

namespace {

constexpr auto stopped = "stopped until it is loaded again";

// Loads the hostile script between two honest ones; what the log says of it.
std::string outcome(const std::string& text, FakeWorld& world) {
    const std::string honest = "local n = 0 hyrax.every(0.1, function() n = n + 1 print(n) end)";
    const PetKey pet = world.add_pet();
    world.load({{"first.lua", honest}, {"bad.lua", text}, {"last.lua", honest}});
    world.play(0.5);
    CHECK(world.said().contains("4\n4\n"));
    CHECK(world.find(pet) != nullptr);
    return world.errors();
}

// A part of the usual budget of a main chunk: what does not end does so sooner.
std::string outcome(const std::string& text) {
    FakeWorld world(ScriptLimits{.load_units = 4'000'000});
    return outcome(text, world);
}

void must_be_killed(const std::string& text) {
    CAPTURE(text);
    const std::string errors = outcome(text);
    CAPTURE(errors);
    CHECK(errors.starts_with("bad.lua:"));
    CHECK(errors.contains(stopped));
}

void must_fail(const std::string& text, const std::string& part) {
    CAPTURE(text);
    const std::string errors = outcome(text);
    CAPTURE(errors);
    CHECK(errors.starts_with("bad.lua"));
    CHECK(errors.contains(part));
    CHECK_FALSE(errors.contains(stopped));
}

}  // namespace

TEST_CASE("an endless loop is stopped, wherever it hides") {
    must_be_killed("while true do end");
    must_be_killed("while true do pcall(function() while true do end end) end");
    must_be_killed("local function f() while true do end end while true do xpcall(f, f) end");
    must_be_killed("while true do coroutine.resume(coroutine.create(function() "
                   "while true do end end)) end");
    must_be_killed("local co = coroutine.create(function() while true do "
                   "pcall(function() coroutine.yield() while true do end end) end end) "
                   "while true do coroutine.resume(co) end");
    must_be_killed("local mt = { __close = function() while true do end end } "
                   "coroutine.wrap(function() local x <close> = setmetatable({}, mt) "
                   "while true do end end)()");
    must_be_killed("local mt = { __close = function() while true do end end } "
                   "local co = coroutine.create(function() "
                   "local x <close> = setmetatable({}, mt) coroutine.yield() end) "
                   "coroutine.resume(co) coroutine.close(co)");
    must_be_killed(
        "local x <close> = setmetatable({}, { __close = function() while true do end end }) "
        "while true do end"
    );
    must_be_killed("hyrax.task(function() while true do end end) while true do end");
    must_be_killed("local function f() coroutine.wrap(f)() end while true do pcall(f) end");
    must_be_killed("table.sort({ 3, 2, 1 }, function() while true do end end)");
    must_be_killed("('x'):gsub('x', function() while true do end end)");
    must_be_killed("setmetatable(_G, { __index = function() while true do end end }) print(y)");
    must_be_killed("load(function() while true do end end)");
    must_be_killed("while true do hyrax.pets() end");
    must_be_killed("print(setmetatable({}, { __tostring = function() while true do end end }))");
}

TEST_CASE("no code of a killed script runs afterwards") {
    FakeWorld world;
    const std::string errors = outcome(
        R"(
        local tell = print
        local closing = setmetatable({}, { __close = function() tell("closed") hyrax.spawn() end })
        local printing = setmetatable({}, { __close = tell })
        hyrax.on("click", function() tell("click") end)
        hyrax.every(0.1, function() tell("timer") end)
        hyrax.task(function() hyrax.wait(0.1) tell("task") end)
        local outer <close> = closing
        pcall(function()
            local a <close> = closing
            local b <close> = printing
            coroutine.wrap(function()
                local c <close> = closing
                while true do end
            end)()
            tell("after wrap")
        end)
        tell("after pcall")
    )",
        world
    );
    CHECK(errors.contains(stopped));
    CHECK(errors.contains("bad.lua:14: used more than 20000000 work units"));
    for (const char* const line : {"closed", "click", "timer", "task", "after", "table"}) {
        CHECK_FALSE(world.said().contains(line));
    }
    CHECK(world.given<command::Spawn>().empty());
}

TEST_CASE("a handler that hangs is stopped with the budget of a callback") {
    FakeWorld world;
    const PetKey pet = world.add_pet();
    world.load("hyrax.on('click', function()\nwhile true do end end)");
    CHECK(world.errors() == "");
    world.happens({.kind = EventKind::click}, pet);
    world.run();
    CHECK(world.errors().starts_with("test.lua:2: used more than 2000000 work units in one call"));
    CHECK(world.last.listening == EventMask{});
    must_be_killed("hyrax.every(0.01, function() while true do pcall(function() "
                   "while true do end end) end end)");
    must_be_killed("hyrax.wait(0.1) while true do end");
}

TEST_CASE("finalizers and weak keys are not to be had") {
    must_fail("setmetatable({}, { __gc = function() while true do end end })", "__gc");
    must_fail("setmetatable({}, { __gc = true })", "__gc");
    must_fail("setmetatable({}, { __mode = 'k' })", "__mode");
    CHECK(
        outcome("local ran, mt = false, {} for i = 1, 100 do setmetatable({}, mt) end "
                "mt.__gc = function() ran = true end "
                "for i = 1, 2e5 do local t = { i } end assert(not ran)") == ""
    );
}

TEST_CASE("tables stay strong, and a chain of them costs the collector no time") {
    CHECK(outcome(R"(
        local mt = {}
        local t = setmetatable({}, mt)
        mt.__mode = "kv"
        t[{}] = {}
        for i = 1, 2e5 do local x = { i } end
        assert(next(t))
    )") == "");
    // With weak keys this would hold the collector up for seconds in one step.
    CHECK(outcome(R"(
        local n, mt, keys, by_index = 30000, {}, {}, {}
        for i = 1, n + 1 do keys[i] = {} end
        for i = 1, n do by_index[i] = setmetatable({ [keys[i]] = keys[i + 1] }, mt) end
        local probe = setmetatable({ [{}] = true }, mt)
        rawset(mt, "__mode", "k")
        local tabs, lo, hi = {}, 1, n
        for i = 1, n do
            if i % 2 == 1 then tabs[lo] = by_index[i] lo = lo + 1 else tabs[hi] = by_index[i] hi = hi - 1 end
        end
        by_index = nil
        first = keys[1] keys = nil
        for i = 1, 3e5 do local t = {} end
        assert(next(probe))
    )") == "");
}

TEST_CASE("memory is capped, and running into the cap is an ordinary error") {
    const std::string memory = "not enough memory";
    must_fail("local s = ('x'):rep((1 << 31) - 100)", memory);
    must_fail("local s = ('x'):rep((1 << 20) + 100)", memory);
    must_fail("local s = 'x' while true do s = s .. s end", memory);
    must_fail("local t = {} for i = 1, 1e9 do t[i] = { i } end", memory);
    must_fail("local t = {} for i = 1, 1e9 do t[i] = function() return i end end", memory);
    must_fail("local s = ('x'):rep(1 << 16) s:gsub('x', ('y'):rep(1 << 16))", memory);
    must_fail("table.concat(setmetatable({}, { __index = type }), '', 1, 1 << 50)", "");
    must_fail("table.unpack({}, 1, 1e8)", "too many results");
    must_be_killed("while true do pcall(string.rep, 'x', 1 << 30) end");
    CHECK(outcome("local s = ('x'):rep(1 << 20) assert(#s == 1 << 20)") == "");
    CHECK(
        outcome("local ok = pcall(function() local t = {} for i = 1, 1e9 do t[i] = { i } end end) "
                "assert(not ok) print('goes on')") == ""
    );
}

TEST_CASE("recursion ends as an error") {
    must_fail("local function f() return 1 + f() end f()", "");
    must_fail("local function f() return (('x'):gsub('x', f)) end f()", "stack overflow");
    must_fail(
        "local function f() return pcall(f) end local function g() return 1 + g() end g()", ""
    );
    must_fail(
        "local s = setmetatable({}, { __concat = function(a, b) return a .. b end }) "
        "s = s .. s",
        ""
    );
    must_fail(
        "local function g() return coroutine.wrap(function() return g() end)() end g()",
        "stack overflow"
    );
    must_fail("local t = {} t.__index = t setmetatable(t, t) return t.x", "loop");
    must_fail("local function f() hyrax.task(f) end f() error('done')", "stack overflow");
}

TEST_CASE("library calls that loop without an instruction are charged before they start") {
    must_be_killed("table.move({}, 1, 1 << 60, 1, {})");
    must_be_killed(
        "table.insert(setmetatable({}, { __len = function() return 1 << 60 end }), 1, nil)"
    );
    must_be_killed("table.remove(setmetatable({}, { __len = function() return 1 << 60 end }), 1)");
    must_be_killed("table.sort(setmetatable({}, { __len = function() return (1 << 31) - 2 end }), "
                   "math.type)");
    must_be_killed("local n = 0 table.sort(setmetatable({}, { __len = function() n = n + 1 "
                   "return n == 1 and 3 or 1 << 40 end }), math.type) while true do end");
    must_be_killed("local s = ('a'):rep(900000) s:find(('a'):rep(450000) .. 'b', 1, true)");
    must_be_killed("local s = ('a'):rep(400000) s:find('[' .. ('b'):rep(400000) .. ']')");
    must_be_killed("local s = ('\\u{20AC}'):rep(300000) while true do utf8.offset(s, -1, 1) "
                   "utf8.len(s) end");
    must_be_killed("local f = ('i1'):rep(200000) while true do pcall(string.packsize, f) end");
    must_be_killed("local s = ('local a = 1 '):rep(100) while true do load(s) end");
    must_be_killed("while true do print(('x'):rep(1000)) end");
}

TEST_CASE("instructions that cost more than others are charged for what they allocate") {
    must_be_killed(
        "local a, b = ('x'):rep(500000), ('y'):rep(500000) while true do local c = a .. b end"
    );
    must_be_killed("local a = ('x'):rep(1000000) while true do local c = a:upper() end");
}

namespace {

std::chrono::nanoseconds fake_time{};

std::chrono::nanoseconds processor_time() {
    return fake_time += std::chrono::milliseconds(30);
}

}  // namespace

TEST_CASE("the clock ends what the units undercount") {
    must_be_killed("local a = ('x'):rep(1000000) local b, n = a:gsub('x$', 'y'), 0 "
                   "while true do if a < b then n = n + 1 end end");
    must_be_killed("local t = {} for i = 1, 131072 do t['k' .. i] = i end "
                   "for k in pairs(t) do t[k] = nil end while true do next(t) end");
}

TEST_CASE("only processor time counts against a script, not time on the wall") {
    // Each look at the processor's clock moves it by 30 ms; the wall moves 1 ms between them.
    const ScriptLimits limits{
        .load_units = INT64_MAX / 2,
        .load_time = std::chrono::milliseconds(100),
        .processor_time = processor_time
    };
    const std::string errors = errors_of(
        "local x <close> = setmetatable({}, { __close = function() while true do end end }) "
        "while true do end",
        limits
    );
    CHECK(errors.contains("used more than 100 ms of processor time in one call"));
}

TEST_CASE("growing memory is a sign of life, so that the watchdog waits for the cap") {
    const auto beats = [](const std::string& last) {
        ScriptPulse pulse{};
        const std::string text =
            "table.concat(setmetatable({}, { __index = type }), '', 1, " + last + ")";
        CHECK(errors_of(text, {.pulse = &pulse}).contains("not enough memory") == (last != "1"));
        return pulse.beats.load();
    };
    // No instruction runs; the buffer doubles from 1 KiB to half the cap of 16 MiB.
    CHECK(beats("1 << 50") >= beats("1") + 13);
}

TEST_CASE("bytecode is refused") {
    must_fail("assert(load('\\27Lua\\x54\\0\\x19\\x93\\r\\n\\x1a\\n', 'x', 'b'))", "binary chunk");
    must_fail("local d = string.dump(print)", "dump");
}

TEST_CASE("an assignment through a metatable that is its own __newindex is safe") {
    CHECK(outcome(R"(
        for r = 1, 200 do
            local mt = {}
            mt.__newindex = mt
            for i = 1, 50 do
                local t = setmetatable({}, mt)
                t.__newindex = { "payload" .. i .. r }
                mt.__newindex = mt
                for j = 1, 20 do local junk = { j } end
            end
        end
    )") == "");
}

TEST_CASE("a flood of spawns ends at the limit, a flood of log lines at the quota") {
    must_fail("for i = 1, 1e6 do hyrax.spawn() end", "limit");
    FakeWorld world;
    world.load("while true do print(('x'):rep(1000)) end");
    const std::string said = world.said();
    CHECK(std::ranges::count(said, '\n') == 100);
}

TEST_CASE("a killed script gives its memory back and can be loaded again") {
    FakeWorld world(ScriptLimits{.load_units = 4'000'000});
    for (int i = 0; i < 10; ++i) {
        world.load("local t = {} for i = 1, 2e5 do t[i] = {} end while true do end");
        world.run();
    }
    CHECK(world.last.next_wake == never);
    world.load("print('fine')");
    CHECK(world.said() == "fine\n");
}
