// SPDX-License-Identifier: MIT
// The whole daemon: what scripts see and ask of the system, and what users ask of it.
#include "daemon/core/remote_script_host.h"
#include "tests/core/fake_script_channel.h"
#include "tests/headless/recorded_daemon.h"

#include <doctest/doctest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <sstream>

using namespace hyrax;

namespace {

constexpr const char* no_pets = R"({"pets": {"start": []}})";

std::size_t spawned(const RecordedDaemon& recorded) {
    return recorded.daemon->engine().size();
}

Vec2 place_of_last(const Daemon& daemon) {
    Vec2 place{-1.0, -1.0};
    daemon.engine().for_each([&](PetId, const Pet& pet) { place = pet.spawn_position; });
    return place;
}

std::string keys_of(const RecordedDaemon& recorded) {
    std::string text;
    for (const auto& [id, keys] : recorded.desktop.hotkeys()) {
        text += text_of(keys) + " ";
    }
    return text;
}

}  // namespace

TEST_CASE("a hotkey is heard, and the pointer is where it is at that moment") {
    RecordedDaemon recorded(3.0);
    recorded.config(no_pets);
    recorded.script("here.lua", R"(
        hyrax.hotkey("ctrl+alt+h", "Here", function()
            local x, y = hyrax.cursor()
            hyrax.spawn{ x = x, y = y }
        end))");
    recorded.at(0.5, input::Moved{.at = {300, 200}});
    recorded.at(1.0, input::HotkeyPressed{1});
    recorded.at(1.2, input::HotkeyPressed{2});  // nobody's
    recorded.look(2.0, [&](const Daemon& daemon) {
        CHECK(keys_of(recorded) == "ctrl+alt+h ");
        CHECK(spawned(recorded) == 1);
        CHECK(place_of_last(daemon) == Vec2{300.0, 200.0});
    });
    recorded.run();
    CHECK(recorded.desktop.hotkeys().empty());
    CHECK(recorded.desktop.window_readings() == 0);
    CHECK(recorded.desktop.pointer_readings() < 10);  // not in every frame
}

TEST_CASE("scripts that ask for nothing cost no look at the pointer or at windows") {
    RecordedDaemon recorded(3.0);
    recorded.config(R"({"pets": {"start": [{"x": 300, "y": 0}]}})");
    recorded.script("tick.lua", "hyrax.on('tick', function() hyrax.pets() end)");
    recorded.run();
    CHECK(recorded.desktop.pointer_readings() == 0);
    CHECK(recorded.desktop.window_readings() == 0);
}

TEST_CASE("windows are listed from the top, without overlays and bars, ten times a second") {
    RecordedDaemon recorded(10.0);
    recorded.config(R"({"pets": {"start": [{"x": 300, "y": 0}]}})");
    recorded.script("count.lua", R"(
        hyrax.on("tick", function()
            local list = hyrax.windows()
            for i, w in ipairs(list) do
                hyrax.store.set("w" .. i, w.x .. " " .. w.y .. " " .. w.w)
            end
            hyrax.store.set("n", #list)
        end))");
    const auto window = [](std::uint64_t id, Rect bounds) {
        return DesktopWindow{.id = id, .bounds = bounds};
    };
    DesktopWindow overlay = window(3, {0, 0, 500, 500});
    overlay.solid = false;
    DesktopWindow bar = window(4, {0, 1000, 1920, 80});
    bar.has_caption = false;
    DesktopWindow hidden = window(5, {0, 0, 100, 100});
    hidden.visible = false;
    recorded.desktop.set_windows(
        {{0, {overlay, window(1, {10, 20, 300, 200}), bar, hidden, window(2, {5, 6, 700, 80})}}}
    );
    recorded.run();
    CHECK(recorded.desktop.window_readings() > 50);
    CHECK(recorded.desktop.window_readings() <= 101);
    const std::string store = recorded.folder.read("store/count.lua.json");
    CAPTURE(store);
    CHECK(store.contains("\"10 20 300\""));
    CHECK(store.contains("\"5 6 700\""));
    CHECK_FALSE(store.contains("w3"));
}

TEST_CASE("a script's hotkeys go and come with it") {
    RecordedDaemon recorded(10.0);
    recorded.config(no_pets);
    recorded.desktop.occupy(*parse_keys("win+l"));
    recorded.script("a.lua", "hyrax.hotkey('f5', 'x', print) hyrax.hotkey('win+l', 'x', print)");
    recorded.script("b.lua", "hyrax.hotkey('f6', 'x', print)");
    recorded.look(0.5, [&](const Daemon&) { CHECK(keys_of(recorded) == "f5 f6 "); });
    recorded.change_file(1.0, "scripts/a.lua", "hyrax.hotkey('f7', 'x', print)");
    recorded.look(1.5, [&](const Daemon&) { CHECK(keys_of(recorded) == "f6 f7 "); });
    recorded.change_file(2.0, "scripts/a.lua", "hyrax.hotkey('f8', 'x', print) error('no')");
    recorded.look(2.5, [&](const Daemon&) { CHECK(keys_of(recorded) == "f6 f7 "); });
    recorded.change_file(
        3.0,
        "scripts/a.lua",
        "hyrax.hotkey('f9', 'x', print) hyrax.after(1, function() while true do end end)"
    );
    recorded.look(3.5, [&](const Daemon&) { CHECK(keys_of(recorded) == "f6 f9 "); });
    recorded.look(5.0, [&](const Daemon&) { CHECK(keys_of(recorded) == "f6 "); });
    recorded.at(6.0, Request{request::SetScript{"b.lua", false}});
    recorded.look(6.5, [&](const Daemon&) { CHECK(keys_of(recorded).empty()); });
    recorded.at(7.0, Request{request::SetScript{"b.lua", true}});
    recorded.look(7.5, [&](const Daemon&) { CHECK(keys_of(recorded) == "f6 "); });
    recorded.run();
    CHECK(recorded.desktop.hotkeys().empty());
}

TEST_CASE("nobody hears a hotkey while the world stands still, nor afterwards") {
    RecordedDaemon recorded(5.0);
    recorded.config(no_pets);
    recorded.script("a.lua", "hyrax.hotkey('f5', 'x', function() hyrax.spawn{} end)");
    recorded.at(1.0, Request{request::SetPaused{true}});
    recorded.at(2.0, input::HotkeyPressed{1});
    recorded.at(3.0, Request{request::SetPaused{false}});
    recorded.run();
    CHECK(spawned(recorded) == 0);
}

TEST_CASE("the user's hotkeys are heard in any state, and change with config.json") {
    RecordedDaemon recorded(20.0);
    recorded.config(R"({"pets": {"start": [{"x": 1900, "y": 0}]}, "hotkeys":
        {"gather": "f5", "hide": "f6", "pause": "f7", "quiet": "f8", "click_through": "f9"}})");
    const auto status = [&] { return recorded.desktop.statuses().back(); };
    recorded.at(1.0, input::HotkeyPressed{2});
    recorded.look(1.5, [&](const Daemon&) {
        CHECK(keys_of(recorded) == "f5 f6 f7 f8 f9 ");
        CHECK(status().hidden);
    });
    recorded.at(2.0, input::HotkeyPressed{2});
    recorded.at(2.0, input::HotkeyPressed{3});
    recorded.look(2.5, [&](const Daemon&) {
        CHECK_FALSE(status().hidden);
        CHECK(status().paused);
    });
    for (const HotkeyId id : {HotkeyId{3}, HotkeyId{4}, HotkeyId{5}}) {
        recorded.at(3.0, input::HotkeyPressed{id});
    }
    recorded.look(3.5, [&](const Daemon&) {
        CHECK_FALSE(status().paused);
        CHECK(status().quiet);
        CHECK(status().click_through);
    });
    recorded.at(4.0, input::HotkeyPressed{4});
    recorded.at(4.0, input::HotkeyPressed{5});
    recorded.at(8.0, input::HotkeyPressed{1});
    recorded.look(8.2, [&](const Daemon& daemon) {
        CHECK_FALSE(status().quiet);
        CHECK_FALSE(status().click_through);
        daemon.engine().for_each([](PetId, const Pet& pet) { CHECK(pet.position().x < 1100.0); });
    });
    recorded.change_file(
        9.0, "config.json", R"({"hotkeys": {"gather": "ctrl+alt+f5", "hide": "f6"}})"
    );
    recorded.look(9.5, [&](const Daemon&) { CHECK(keys_of(recorded) == "f6 ctrl+alt+f5 "); });
    recorded.change_file(10.0, "config.json", R"({"hotkeys": {"gather": "g"}})");
    recorded.look(10.5, [&](const Daemon&) {
        CHECK(keys_of(recorded) == "f6 ctrl+alt+f5 ");
        CHECK(status().problem.contains("('g' needs ctrl, alt or win beside it), got \"g\""));
    });
    recorded.run();
    CHECK(recorded.desktop.hotkeys().empty());
}

TEST_CASE("click-through: the menu's word against the config's, a held pet is let go") {
    RecordedDaemon recorded(12.0);
    recorded.config(
        R"({"overlay": {"click_through": true}, "pets": {"start": [{"x": 900, "y": 0}]}})"
    );
    recorded.look(1.0, [&](const Daemon&) {
        CHECK(recorded.desktop.conduct().click_through);
        CHECK(recorded.desktop.statuses().back().click_through);
    });
    recorded.at(2.0, Request{request::SetClickThrough{false}});
    recorded.look(7.0, [&](const Daemon& daemon) {
        CHECK_FALSE(recorded.desktop.conduct().click_through);
        CHECK_FALSE(recorded.desktop.conduct().let_go);
        const Rect bounds = daemon.frame().sprites.at(0).bounds();
        const Point middle{bounds.x + bounds.width / 2, bounds.y + bounds.height / 2};
        const Ticks time = from_seconds(7.1);
        recorded.desktop.add({time, input::Pressed{middle, Button::left, time}});
    });
    recorded.look(7.2, [&](const Daemon& daemon) {
        CHECK(only_pet(daemon).motion == Motion::held);
        CHECK(recorded.desktop.conduct().dragging);
        CHECK(state_of(recorded).contains("\"click_through\": false"));
    });
    recorded.at(8.0, Request{request::SetClickThrough{true}});
    recorded.look(8.1, [&](const Daemon& daemon) {
        CHECK(only_pet(daemon).motion != Motion::held);
        CHECK(recorded.desktop.conduct().let_go);
        CHECK_FALSE(recorded.desktop.conduct().dragging);
    });
    recorded.run();
    CHECK_FALSE(state_of(recorded).contains("click_through"));
}

TEST_CASE("notices are shown with the script's name, unless somebody must not be disturbed") {
    const Rect screen_bounds{0, 0, 1920, 1080};
    const Facts film{
        .windows = {{.bounds = screen_bounds, .window_class = "Player"}}, .first_is_front = true
    };
    struct Case {
        const char* name;
        Input before;
        std::size_t shown;
    };
    const Case cases[] = {
        {"usual", input::MonitorsChanged{}, 1},
        {"film", input::FactsChanged{film, 0}, 0},
        {"talk", input::FactsChanged{{.shell = ShellState::presenting}, 0}, 0},
        {"quiet", Request{request::SetQuiet{true}}, 0},
        {"hidden", Request{request::Hide{}}, 0},
    };
    for (const Case& each : cases) {
        CAPTURE(each.name);
        RecordedDaemon recorded(5.0);
        recorded.config(no_pets);
        recorded.script("a.lua", "hyrax.after(2, function() hyrax.notify('It rains.') end)");
        recorded.at(1.0, each.before);
        recorded.run();
        REQUIRE(recorded.desktop.notices().size() == each.shown);
        if (each.shown == 1) {
            CHECK(recorded.desktop.notices()[0] == RecordedNotice{"a.lua", "It rains."});
        }
    }
}
