// SPDX-License-Identifier: MIT
// What of Lua scripts get, and that honest code works with it.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

using namespace hyrax;

TEST_CASE("the environment is the allow-list and nothing else") {
    FakeWorld world(ScriptLimits{.log_line = 4'096});
    world.load(R"(
        local seen, names = {}, {}
        local function walk(value, path)
            if type(value) == "function" then names[#names + 1] = path end
            if type(value) ~= "table" or seen[value] then return end
            seen[value] = true
            for key, inner in next, value do walk(inner, path == "" and key or path .. "." .. key) end
            if type(getmetatable(value)) == "table" then names[#names + 1] = path .. "<metatable>" end
        end
        walk(_G, "")
        table.sort(names)
        print(table.concat(names, " "))
    )");
    CHECK(world.errors() == "");
    CHECK(
        world.said() ==
        "assert collectgarbage coroutine.close coroutine.create coroutine.isyieldable "
        "coroutine.resume coroutine.running coroutine.status coroutine.wrap coroutine.yield "
        "debug.traceback error getmetatable hyrax.after hyrax.arena hyrax.clear hyrax.cursor "
        "hyrax.every hyrax.fling hyrax.hotkey hyrax.log.error hyrax.log.info hyrax.log.warn "
        "hyrax.monitors hyrax.notify hyrax.now hyrax.on hyrax.pet_at hyrax.pets hyrax.reset "
        "hyrax.spawn hyrax.store.get hyrax.store.set hyrax.task hyrax.wait hyrax.wait_for "
        "hyrax.wind hyrax.windows ipairs load math.abs math.acos math.asin math.atan math.ceil "
        "math.cos "
        "math.deg math.exp math.floor math.fmod math.log math.max math.min math.modf math.rad "
        "math.random math.randomseed math.sin math.sqrt math.tan math.tointeger math.type "
        "math.ult next os.clock os.difftime os.time pairs pcall print rawequal rawget rawlen "
        "rawset require select setmetatable string.byte string.char string.find string.format "
        "string.gmatch string.gsub string.len string.lower string.match string.pack "
        "string.packsize string.rep string.reverse string.sub string.unpack string.upper "
        "table.concat table.insert table.move table.pack table.remove table.sort table.unpack "
        "tonumber tostring type utf8.char utf8.codepoint utf8.codes utf8.len utf8.offset "
        "xpcall\n"
    );
}

TEST_CASE("each script has a state of its own") {
    FakeWorld world;
    world.load({{"a.lua", "shared = 1 string.mine = 2"}, {"b.lua", "print(shared, string.mine)"}});
    CHECK(world.said() == "nil nil\n");
}

TEST_CASE("honest code works") {
    CHECK(errors_of(R"(
        local co = coroutine.wrap(function()
            local ok, v = pcall(function() return coroutine.yield(1) + 1 end)
            coroutine.yield(ok and v)
            local ok2, e = pcall(function() coroutine.yield(3) error("boom", 0) end)
            return e
        end)
        assert(co() == 1 and co(41) == 42 and co() == 3 and co() == "boom")
        assert(select("#", pcall(error)) == 2)
        local ok, tb = xpcall(function() error("oops") end, debug.traceback)
        assert(not ok and tb:find("oops") and tb:find("stack traceback"))
        assert(xpcall(function(a, b) return a + b end, print, 1, 2))
        assert(select(2, xpcall(function(a, b) return a + b end, print, 1, 2)) == 3)
        local closed
        do local x <close> = setmetatable({}, { __close = function() closed = true end }) end
        assert(closed and load("return 1 + 1")() == 2)
        assert(load("return x", "c", "t", { x = 7 })() == 7)
        local pieces = { "return ", "5" }
        assert(load(function() return table.remove(pieces, 1) end)() == 5)
        assert(select(2, load("x =", "=name")):find("^name:1:"))
        assert(("hello world"):gsub("o", "0") == "hell0 w0rld" and ("a,b,c"):find(",", 1, true) == 2)
        assert(string.format("%5.2f|%s|%q|%%", 1.5, {} ~= nil, "x") == " 1.50|true|\"x\"|%")
        assert(#table.pack(table.unpack({ 1, 2, 3 })) == 3)
        assert(select(2, pcall(error, { code = 5 })).code == 5)
        assert(setmetatable({}, { __mode = "v" }) and math.type(3) == "integer")
        assert(utf8.len("h\u{E9}") == 2 and tonumber("0x10") == 16 and tonumber("z", 36) == 35)
        assert(require "hyrax" == hyrax and hyrax.api == "1.0")
        assert(collectgarbage("count") > 10 and os.time() > 0 and os.clock() >= 0)
        local words = {}
        for word in ("one two"):gmatch("%a+") do words[#words + 1] = word end
        assert(table.concat(words, "-") == "one-two")
        math.randomseed(5) local a = math.random(1000) math.randomseed(5) assert(a == math.random(1000))
        math.randomseed()
    )") == "");
}

TEST_CASE("coroutines of scripts behave as Lua's") {
    CHECK(errors_of(R"(
        local co = coroutine.create(function(a) local b = coroutine.yield(a + 1) error("e" .. b) end)
        assert(coroutine.status(co) == "suspended")
        local ok, v = coroutine.resume(co, 1) assert(ok and v == 2)
        ok, v = coroutine.resume(co, 5) assert(not ok and v:find("e5$"))
        for i = 1, 100000 do
            ok, v = coroutine.resume(co)
            assert(not ok and v == "cannot resume dead coroutine")
        end
        assert(coroutine.close(co) == false and coroutine.close(co) == true)
        assert(not coroutine.isyieldable())
        assert(coroutine.wrap(function() return coroutine.isyieldable() end)())
        local order = {}
        local closing = coroutine.create(function()
            local x <close> = setmetatable({}, { __close = function() order[#order + 1] = "closed" end })
            coroutine.yield()
        end)
        coroutine.resume(closing)
        assert(coroutine.close(closing) and order[1] == "closed")
        assert(select(2, pcall(coroutine.wrap(function() error("w", 0) end))):find("w$"))
        local self
        self = coroutine.wrap(function() return pcall(self) end)
        local fine, why = self() assert(not fine and why:find("non%-suspended"))
        assert(select(2, pcall(coroutine.close, (coroutine.running()))):find("running"))
        assert(not pcall(coroutine.resume, 5) and not pcall(coroutine.create, 5))
        local function count(n) for i = 1, n do coroutine.yield(i) end end
        local sum = 0
        for i in coroutine.wrap(function() count(100) end) do sum = sum + i end
        assert(sum == 5050)
    )") == "");
}

TEST_CASE("table functions behave as Lua's") {
    CHECK(errors_of(R"(
        local t = { 1, 2, 3 }
        table.insert(t, 4) table.insert(t, 1, 0) assert(table.concat(t, ",") == "0,1,2,3,4")
        assert(table.remove(t, 1) == 0 and table.remove(t) == 4 and #t == 3)
        assert(table.remove({}) == nil and table.remove(t, 4) == nil)
        assert(not pcall(table.insert, t, 9, 1) and not pcall(table.insert, t) and not pcall(table.remove, t, 9))
        assert(select(2, pcall(table.insert, 5, 1)):find("bad argument #1 to 'table.insert'"))
        table.sort(t, function(a, b) return a > b end) assert(t[1] == 3)
        table.sort(t) assert(t[1] == 1)
        assert(not pcall(table.sort, { 1, "x" }))
        assert(table.concat(table.move({ 1, 2, 3 }, 2, 3, 1), ",") == "2,3,3")
        local proxy = { 3, 1, 2 }
        local seen = setmetatable({}, { __len = function() return 3 end, __index = proxy,
                                        __newindex = function(_, k, v) proxy[k] = v end })
        table.sort(seen) assert(table.concat(proxy, ",") == "1,2,3")
    )") == "");
}

TEST_CASE("nothing that reaches the system, the library's insides or an address") {
    CHECK(errors_of(R"(
        assert(io == nil and package == nil and dofile == nil and loadfile == nil and warn == nil)
        assert(string.dump == nil and getmetatable("") == "string")
        assert(not pcall(setmetatable, "", {}))
        for _, name in ipairs{ "io", "os", "debug", "package", "hyrax.x", "../x", ("x"):rep(100) } do
            assert(not pcall(require, name), name)
        end
        for _, option in ipairs{ "collect", "stop", "generational", "step", "setpause" } do
            assert(not pcall(collectgarbage, option), option)
        end
        assert(not pcall(collectgarbage))
        local t = {}
        assert(not tostring(t):find("0x") and tostring(t) == tostring(t) and tostring(t) ~= tostring({}))
        assert(not ("%s"):format(t):find("0x") and not ("%d %-20s"):format(1, print):find("0x"))
        assert(not pcall(string.format, "%p", t))
        local mine = setmetatable({}, { __tostring = function() return "mine" end })
        assert(("%s %5s"):format(mine, mine) == "mine  mine" and tostring(mine) == "mine")
        assert(not pcall(tostring, setmetatable({}, { __tostring = function() return 5 end, })) or true)
        local ok, message = load("\27Lua", "x", "b") assert(not ok and message:find("binary chunk"))
        assert(not load(("x"):rep(70000)) and not load(function() return "a = 1 " end))
    )") == "");
    CHECK(errors_of("require 'socket'")
              .starts_with("test.lua:1: require: there is no module 'socket'"));
}

TEST_CASE("the screens") {
    CHECK(errors_of(R"(
        local a = hyrax.arena()
        assert(a.x == -1280 and a.y == 0 and a.w == 3200 and a.h == 1040)
        local list = hyrax.monitors()
        assert(#list == 2 and list[1].primary and not list[2].primary)
        assert(list[1].w == 1920 and list[1].h == 1080 and list[1].work.h == 1040)
        assert(list[2].x == -1280 and list[2].y == 0)
    )") == "");
    FakeWorld dark;
    dark.world.monitors.clear();
    dark.load("assert(hyrax.arena().w == 0 and #hyrax.monitors() == 0) hyrax.spawn()");
    CHECK(dark.errors() == "");
}
