// SPDX-License-Identifier: MIT
// What belongs to a script: store, settings, permissions, hotkeys, notices; and how it leaves.
#include "tests/script/fake_world.h"

#include <doctest/doctest.h>

#include <string>

using namespace hyrax;

namespace {

ScriptSource source(std::string text) {
    return {.name = "test.lua", .text = std::move(text)};
}

std::string errors_without_permissions(const std::string& text) {
    FakeWorld world;
    world.permissions = {};
    world.load(text);
    return world.errors();
}

}  // namespace

TEST_CASE("what is stored is read back, as a copy, and goes out as a command") {
    FakeWorld world;
    world.load(R"(
        local store = hyrax.store
        assert(store.get("a") == nil and store.get("a", 5) == 5)
        for _, value in ipairs{ true, 7, 7.5, "text\n", -1 } do
            store.set("a", value)
            assert(store.get("a") == value and math.type(store.get("a")) == math.type(value))
        end
        local list = { 1, { x = "y", z = { true, false } } }
        store.set("t", list)
        list[1] = 2
        local back = store.get("t")
        assert(back[1] == 1 and back[2].x == "y" and back[2].z[2] == false and #back == 2)
        back[1] = 3
        assert(store.get("t")[1] == 1)
        store.set("a", nil)
        assert(store.get("a", "gone") == "gone")
        store.set("same", 1) store.set("same", 1) store.set("never", nil)
    )");
    CHECK(world.errors() == "");
    const auto kept = world.given<command::Store>();
    REQUIRE(kept.size() == 8);
    CHECK(kept[0].script == "test.lua");
    CHECK(kept[0].key == "a");
    CHECK(kept[0].value == ScriptValue{true});
    CHECK(kept[1].value == ScriptValue{std::int64_t{7}});
    CHECK(kept[6].value.is_nothing());
    const auto* const list = std::get_if<ScriptValue::List>(&kept[5].value.data);
    REQUIRE(list != nullptr);
    CHECK(std::get<ScriptTable>((*list)[1].data)[0].name == "x");
}

TEST_CASE("a store comes with the source and survives a reload, what unload keeps included") {
    FakeWorld world;
    ScriptSource first = source(R"(
        print(hyrax.store.get("n"))
        hyrax.on("unload", function() hyrax.store.set("n", hyrax.store.get("n") + 1) end)
    )");
    set_field(first.store, "n", {std::int64_t{41}});
    world.load({first});
    world.renew();
    world.load({first});
    CHECK(world.errors() == "");
    CHECK(world.said() == "41\n42\n");
}

TEST_CASE("what cannot be stored is named with its place") {
    const auto error = [](const std::string& value) {
        return errors_of("hyrax.store.set('key', " + value + ")");
    };
    CHECK(error("print").contains("hyrax.store.set: value must be nil, a boolean, a number"));
    CHECK(error("0/0").contains("value must be a finite number"));
    CHECK(error("{ a = { 1, 1/0 } }").contains("value.a[2] must be a finite number"));
    CHECK(error("{ a = { b = hyrax.spawn() } }").contains("value.a.b must be nil, a boolean"));
    CHECK(error("{ 1, 2, x = 3 }").contains("value mixes a list with other keys"));
    CHECK(error("{ 1, nil, 3 }").contains("value is a list with holes"));
    CHECK(error("{ [1.5] = 1 }").contains("must have names or a list from 1 on as keys"));
    CHECK(error("'\\255'").contains("value must be UTF-8"));
    CHECK(error("{ ['a\\n'] = 1 }").contains("names must have at most 64 bytes"));
    CHECK(error("(function() local t = {} t.t = t return t end)()").contains("more than 16 deep"));
    CHECK(error("(('x'):rep(300000))").contains("limit"));
    CHECK(errors_of("hyrax.store.set('', 1)").contains("hyrax.store.set: key must not be empty"));
    CHECK(errors_of("hyrax.store.set(1, 1)").contains("key must be a string, got number"));
    CHECK(errors_of("hyrax.store.set(('k'):rep(65), 1)").contains("at most 64 bytes"));
    CHECK(errors_of("hyrax.store.get()").contains("hyrax.store.get: key must be a string"));
    const std::string full = "for i = 1, 9 do hyrax.store.set('k' .. i, ('x'):rep(30000)) end";
    CHECK(errors_of(full).contains("hyrax.store.set: limit of 262144 bytes in the store reached"));
}

TEST_CASE("settings are read, listed, protected, and their changes are heard") {
    FakeWorld world;
    ScriptSource plugin = source(R"(
        print(hyrax.config.jumps, hyrax.config.name, hyrax.config.none)
        local keys = {}
        for key in pairs(hyrax.config) do keys[#keys + 1] = key end
        table.sort(keys)
        print(table.concat(keys, " "), next(hyrax.config))
        print(pcall(function() hyrax.config.jumps = 6 end))
        print(getmetatable(hyrax.config), hyrax.plugin.id, hyrax.plugin.version)
        hyrax.on("config", function(key, value) print(key, value, hyrax.config[key]) end)
    )");
    plugin.config = {{"jumps", {std::int64_t{5}}}, {"name", {std::string("x")}}};
    plugin.version = "1.2.0";
    world.load({plugin});
    plugin.config = {{"jumps", {std::int64_t{9}}}};
    world.load({plugin});
    CHECK(world.errors() == "");
    CHECK(
        world.said() == "5 x nil\njumps name nil\n"
                        "false test.lua:7: hyrax.config can only be read; the user changes it\n"
                        "false test.lua 1.2.0\njumps 9 9\nname nil nil\n"
    );
}

TEST_CASE("what needs a permission says so") {
    const auto needs = [](const std::string& call, const std::string& permission) {
        CHECK(errors_without_permissions(call).contains("needs the permission \"" + permission));
        CHECK_FALSE(errors_of(call).contains("permission"));
    };
    needs("hyrax.cursor()", "cursor");
    needs("hyrax.windows()", "windows");
    needs("hyrax.hotkey('f5', 'x', print)", "hotkeys");
    needs("hyrax.notify('x')", "notify");
}

TEST_CASE("cursor and windows tell what the world tells") {
    FakeWorld world;
    world.load("hyrax.every(1, function() print(hyrax.cursor()) print(#hyrax.windows()) end)");
    world.skip(1.0);
    world.world.cursor = Vec2{3.0, -4.5};
    world.world.windows = {{1, 2, 3, 4}};
    world.skip(1.0);
    CHECK(world.errors() == "");
    CHECK(world.said() == "nil\n0\n3.0 -4.5\n1\n");
}

TEST_CASE("hotkeys are asked for, heard, and given back") {
    FakeWorld world;
    world.load(R"(
        local key = hyrax.hotkey("Alt + CTRL+h", "Throw", function() print("pressed") end)
        hyrax.hotkey("f5", "Other", print)
        hyrax.on("click", function() key:cancel() key:cancel() end)
    )");
    auto asked = world.given<command::Hotkey>();
    REQUIRE(asked.size() == 2);
    CHECK(asked[0].keys == "ctrl+alt+h");
    CHECK(asked[0].label == "Throw");
    CHECK(asked[0].id != asked[1].id);
    world.world.pressed_hotkeys = {{"test.lua", asked[0].id}, {"test.lua", 999}, {"x", 1}};
    world.run();
    CHECK(world.said() == "pressed\n");
    world.world.pressed_hotkeys = {};
    world.happens({.kind = EventKind::click}, world.add_pet());
    world.run();
    asked = world.given<command::Hotkey>();
    REQUIRE(asked.size() == 3);
    CHECK(asked[2].id == asked[0].id);
    CHECK(asked[2].keys == "");
    world.load("");
    asked = world.given<command::Hotkey>();
    REQUIRE(asked.size() == 4);
    CHECK(asked[3].id == asked[1].id);
    CHECK(world.errors() == "");
}

TEST_CASE("wrong hotkeys are explained") {
    const auto error = [](const std::string& keys) {
        return errors_of("hyrax.hotkey('" + keys + "', 'x', print)");
    };
    CHECK(error("ctrl+alt+ö").contains("is no key"));
    CHECK(error("hyper+h").contains("'hyper' is not one of ctrl, alt, shift, win"));
    CHECK(error("h").contains("'h' needs ctrl, alt or win beside it"));
    CHECK(error("shift+h").contains("needs ctrl, alt or win"));
    CHECK(error("f25").contains("is no key"));
    CHECK(error("").contains("is no key"));
    CHECK(error("f12") == "");
    CHECK(error("win+pageup") == "");
}

TEST_CASE("notices are limited") {
    FakeWorld world;
    world.load("hyrax.every(10, function() hyrax.notify('hello') end)");
    for (int i = 0; i < 7; ++i) {
        world.skip(10.0);
    }
    CHECK(world.given<command::Notify>().size() == 3);
    CHECK(world.errors().contains("hyrax.notify: limit of one notice in 30 s reached"));
    CHECK(errors_of("hyrax.notify(('x'):rep(201))").contains("at most 200 bytes"));
}

TEST_CASE("unload tells why, cannot wait, and ends") {
    const std::string text = R"(
        hyrax.on("unload", function(reason)
            print(reason)
            hyrax.spawn{ tag = reason }
            print(pcall(hyrax.wait, 1))
        end)
        hyrax.on("unload", function() hyrax.task(function() hyrax.wait(1) end) end)
        hyrax.every(1, function() print("timer") end)
    )";
    FakeWorld world;
    world.load(text);
    world.renew();
    world.load(text);
    world.load("", "other.lua");
    world.load(text);
    world.world.ending = true;
    world.run();
    const std::string refused = "false cannot wait while the script is unloaded\n";
    CHECK(world.said() == "reload\n" + refused + "disable\n" + refused + "exit\n" + refused);
    CHECK(world.given<command::Spawn>().size() == 3);
    CHECK(world.errors().contains("cannot wait while the script is unloaded"));
    CHECK(world.last.next_wake == never);
    CHECK(world.last.listening == EventMask{});
    world.world.ending = false;
    world.skip(5.0);
    CHECK_FALSE(world.said().contains("timer"));
}

TEST_CASE("unload has a small budget for all its handlers together") {
    FakeWorld world;
    const std::string half = "hyrax.on('unload', function() for i = 1, 30000 do end print(1) end) ";
    world.load(half + half + half + half + half + half + half + half);
    world.load("");
    CHECK(world.errors().contains("used more than 200000 work units"));
    CHECK(world.said().starts_with("1\n1\n"));
    CHECK(world.said().size() < 16);
}
