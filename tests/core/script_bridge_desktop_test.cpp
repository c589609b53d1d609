// SPDX-License-Identifier: MIT
// What scripts see and ask of the desktop.
#include "tests/core/script_bridge_stage.h"

#include <functional>
#include <string>

using namespace hyrax;

TEST_CASE("only before a run, and for who may see it and names it, is something looked for") {
    Stage stage;
    int looks = 0;
    const ScriptEyes eyes{
        .cursor = [&looks] { return std::optional(Vec2{double(++looks), 4.0}); },
        .windows = [] { return std::vector<Rect>{{1, 2, 3, 4}}; },
    };
    const auto run = [&](const std::string& text, std::vector<std::string> permissions) {
        stage.bridge.load({{.name = "test.lua", .text = text, .permissions = permissions}});
        stage.bridge.run(stage.engine, {}, 0, eyes);
        stage.bridge.run(stage.engine, {}, 1, eyes);  // nothing is due
    };
    run("hyrax.cursor()", {"windows"});
    run("print(1)", {"cursor"});
    CHECK(looks == 0);
    CHECK_FALSE(stage.recorder.world.cursor);
    run("hyrax.cursor()", {"cursor", "windows"});
    CHECK(looks == 1);
    CHECK(stage.recorder.world.cursor == Vec2{1.0, 4.0});
    CHECK(stage.recorder.world.windows.empty());
    run("hyrax.windows()", {"cursor", "windows"});
    CHECK(looks == 1);
    CHECK_FALSE(stage.recorder.world.cursor);
    CHECK(stage.recorder.world.windows == std::vector<Rect>{{1, 2, 3, 4}});
}

TEST_CASE("pressed hotkeys are told once and at once, and not for ever") {
    Stage stage;
    stage.run(0);
    CHECK(stage.bridge.next_wake() == never);
    stage.bridge.tell(PressedHotkey{"test.lua", 7});
    CHECK(stage.bridge.next_wake() == 0);
    stage.run(1);
    REQUIRE(stage.recorder.world.pressed_hotkeys.size() == 1);
    CHECK(stage.recorder.world.pressed_hotkeys[0].id == 7);
    REQUIRE(stage.engine.spawn({}));
    stage.run(2);
    CHECK(stage.recorder.world.pressed_hotkeys.empty());
    for (std::size_t i = 0; i < 2 * ScriptBridge::most_pressed; ++i) {
        stage.bridge.tell(PressedHotkey{"test.lua", 7});
    }
    stage.run(3);
    CHECK(stage.recorder.world.pressed_hotkeys.size() == ScriptBridge::most_pressed);
}

TEST_CASE("what was asked of the desktop before a loss is void, what comes after it counts") {
    Stage stage;
    stage.recorder.answer.next_wake = 0;
    const auto ask = [](std::string keys) {
        return ScriptCommand{command::Hotkey{"test.lua", 1, std::move(keys), ""}};
    };
    stage.recorder.answer.commands = {ask("f5")};
    stage.run(0);
    CHECK_FALSE(stage.bridge.take_loss());
    stage.recorder.answer.commands = {ask("f6"), command::Notify{"test.lua", "stays"}};
    stage.recorder.answer.lost = true;
    stage.run(1);
    stage.recorder.answer.commands = {ask("f7")};
    stage.recorder.answer.lost = false;
    stage.run(2);
    CHECK(stage.bridge.take_loss());
    CHECK_FALSE(stage.bridge.take_loss());
    const auto wishes = stage.bridge.take_wishes();
    REQUIRE(wishes.size() == 2);
    CHECK(std::holds_alternative<command::Notify>(wishes[0]));
    CHECK(std::get<command::Hotkey>(wishes[1]).keys == "f7");
}
