// SPDX-License-Identifier: MIT
// Menus, hiding, quiet and places, through the whole daemon on the recorded desktop.
#include "daemon/core/files.h"
#include "tests/headless/recorded_daemon.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace hyrax;

namespace {

constexpr std::string_view one_pet = R"({"pets": {"start": [{"x": 900, "y": 400}]}})";
constexpr std::string_view no_pets = R"({"pets": {"start": []}})";
constexpr std::string_view floating =
    R"({"physics": {"gravity": 0, "air_drag": 1},
        "pets": {"start": [{"x": 100, "y": 400, "vx": 50}]}})";

const std::vector<Monitor> two{
    screen({0, 0, 1920, 1080}),
    {.bounds = {1920, 0, 1280, 1024},
     .work = {1920, 0, 1280, 1024},
     .primary = false,
     .name = "DISPLAY2",
     .id = "the right one"},
};

std::optional<MenuAction> action_of(const MenuItems& menu, std::string_view text) {
    for (const MenuItem& item : menu) {
        if (item.text == text) {
            return item.action;
        }
        if (const auto below = action_of(item.children, text)) {
            return below;
        }
    }
    return std::nullopt;
}

/// What the user does with the latest menu.
Request chosen(const RecordedDaemon& recorded, std::string_view text) {
    REQUIRE_FALSE(recorded.desktop.menus().empty());
    const auto action = action_of(recorded.desktop.menus().back(), text);
    REQUIRE_MESSAGE(action, text);
    return std::get<Request>(*action);
}

bool is_ticked(const MenuItems& menu, std::string_view text) {
    return std::ranges::any_of(menu, [text](const MenuItem& item) {
        return (item.text == text && item.checked) || is_ticked(item.children, text);
    });
}

}  // namespace

TEST_CASE("the tray's menu shows what there is") {
    RecordedDaemon recorded(3.0, two);
    recorded.config(no_pets);
    recorded.script("good.lua", "hyrax.log.info('hello')");
    recorded.script("bad.lua", "local x = nil\nx.y = 1");
    recorded.at(1.0, input::MenuWanted{.anchor = {5, 5}, .autostart = true});
    recorded.run();
    REQUIRE(recorded.desktop.menus().size() == 1);
    const MenuItems& menu = recorded.desktop.menus().front();
    CHECK(action_of(menu, "&hyrax"));
    CHECK(is_ticked(menu, "&good.lua"));
    CHECK(is_ticked(menu, "&bad.lua"));
    const bool tells_error = std::ranges::any_of(menu, [](const MenuItem& item) {
        return item.text == "S&cripts" &&
               std::ranges::any_of(item.children, [](const MenuItem& line) {
                   return line.text.starts_with("    bad.lua:2:") && !line.enabled;
               });
    });
    CHECK(tells_error);
    CHECK(is_ticked(menu, "&1: 1920 x 1080, primary"));
    CHECK(is_ticked(menu, "&2: 1280 x 1024"));
    CHECK(is_ticked(menu, "Start with &Windows"));
}

TEST_CASE("a right click on a pet opens its own menu, beside it none") {
    RecordedDaemon recorded(6.0);
    recorded.config(one_pet);
    const auto click = [&](double seconds, Point at, Point up) {
        const Ticks time = from_seconds(seconds);
        recorded.desktop.add({time, input::Pressed{at, Button::right, time}});
        recorded.desktop.add({time + 1, input::Released{up, Button::right, time + 1}});
    };
    recorded.look(3.0, [&](const Daemon& daemon) {
        const Rect bounds = daemon.frame().sprites.at(0).bounds();
        const Point middle{bounds.x + bounds.width / 2, bounds.y + bounds.height / 2};
        click(3.1, middle, middle);
        click(3.3, middle, {10, 10});
        click(3.5, {10, 10}, middle);
    });
    recorded.look(4.0, [&](const Daemon& daemon) {
        CHECK(recorded.desktop.menus().size() == 1);
        CHECK(daemon.engine().size() == 1);
        recorded.desktop.add({from_seconds(4.1), chosen(recorded, "Re&move")});
        // The pet has gone by then.
        recorded.desktop.add({from_seconds(4.2), chosen(recorded, "&Stop")});
    });
    recorded.look(4.3, [](const Daemon& daemon) { CHECK(daemon.engine().size() == 0); });
    recorded.run();
}

TEST_CASE("a pet is stopped, put back, and left alone by its menu") {
    RecordedDaemon recorded(6.0);
    recorded.config(floating);
    PetId first;
    recorded.look(1.0, [&](const Daemon& daemon) {
        daemon.engine().for_each([&](PetId id, const Pet&) { first = id; });
        recorded.desktop.add({from_seconds(2.0), Request{request::StopPet{first}}});
        recorded.desktop.add({from_seconds(3.0), Request{request::ResetPet{first}}});
        recorded.desktop.add({from_seconds(3.5), Request{request::Spawn{.count = 4}}});
        recorded.desktop.add({from_seconds(4.0), Request{request::RemoveOthers{first}}});
    });
    recorded.look(2.5, [](const Daemon& daemon) {
        CHECK(only_pet(daemon).velocity() == Vec2{});
        CHECK(only_pet(daemon).position().x == doctest::Approx(200.0).epsilon(0.02));
    });
    recorded.look(3.2, [](const Daemon& daemon) {
        CHECK(only_pet(daemon).position() == Vec2{100.0, 400.0});
    });
    recorded.look(3.8, [](const Daemon& daemon) { CHECK(daemon.engine().size() == 5); });
    recorded.look(4.5, [&](const Daemon& daemon) {
        CHECK(daemon.engine().size() == 1);
        CHECK(daemon.engine().find(first) != nullptr);
    });
    recorded.run();
}

TEST_CASE("hidden pets have no picture and no time, and nothing wakes the daemon") {
    RecordedDaemon recorded(3000.0);
    recorded.config(floating);
    recorded.script("tick.lua", "n = 0 hyrax.every(1, function() n = n + 1 end)");
    recorded.at(2.0, Request{request::Hide{.seconds = 1800}});
    std::size_t wakeups = 0;
    Vec2 place;
    recorded.look(3.0, [&](const Daemon& daemon) {
        CHECK(daemon.frame().sprites.empty());
        CHECK(recorded.desktop.last_frame().sprites.empty());
        CHECK(recorded.desktop.statuses().back().hidden);
        place = only_pet(daemon).position();
        wakeups = recorded.desktop.timer_wakeups();
    });
    recorded.look(1801.9, [&](const Daemon& daemon) {
        // Each look itself is answered by one frame.
        CHECK(recorded.desktop.timer_wakeups() <= wakeups + 1);
        CHECK(only_pet(daemon).position() == place);
        CHECK(state_of(recorded).contains("\"hidden\": true"));
    });
    recorded.look(1802.1, [&](const Daemon& daemon) {
        CHECK(recorded.desktop.timer_wakeups() <= wakeups + 12);
        CHECK(daemon.frame().sprites.size() == 1);
        CHECK_FALSE(recorded.desktop.statuses().back().hidden);
        CHECK(only_pet(daemon).position().x == doctest::Approx(place.x + 5.0).epsilon(0.02));
        CHECK(state_of(recorded).contains("\"hidden\": false"));
    });
    recorded.run();
}

TEST_CASE("a hidden pet is not grabbed, pausing goes on behind, and Show shows") {
    RecordedDaemon recorded(10.0);
    recorded.config(floating);
    recorded.at(1.0, Request{request::SetPaused{true}});
    recorded.at(2.0, Request{request::Hide{}});
    recorded.at(3.0, Request{request::SetPaused{false}});
    recorded.look(4.0, [](const Daemon& daemon) {
        CHECK(only_pet(daemon).position().x < 160.0);
        CHECK(daemon.frame().sprites.empty());
    });
    recorded.at(5.0, Request{request::Show{}});
    recorded.look(7.0, [](const Daemon& daemon) {
        CHECK(only_pet(daemon).position().x > 240.0);
        CHECK(daemon.frame().sprites.size() == 1);
    });
    recorded.run();
}

TEST_CASE("hiding lets go of the pet in the hand") {
    RecordedDaemon recorded(6.0);
    recorded.config(one_pet);
    recorded.look(3.0, [&](const Daemon& daemon) {
        const Rect bounds = daemon.frame().sprites.at(0).bounds();
        const Point middle{bounds.x + bounds.width / 2, bounds.y + bounds.height / 2};
        const Ticks time = from_seconds(3.1);
        recorded.desktop.add({time, input::Pressed{middle, Button::left, time}});
    });
    recorded.at(3.5, Request{request::Hide{}});
    recorded.look(3.6, [](const Daemon& daemon) {
        CHECK(only_pet(daemon).motion != Motion::held);
    });
    recorded.run();
}

TEST_CASE("what is hidden stays hidden at the next start, until its time has come") {
    // The recorded day begins at 1767268800.
    for (const auto& [until, hidden] :
         {std::pair{"1767268860", true}, std::pair{"1767268700", false}}) {
        RecordedDaemon recorded(70.0);
        recorded.config(one_pet);
        recorded.folder.write(
            "state.json", std::string("{\"hidden\": true, \"hidden_until\": ") + until + "}"
        );
        recorded.look(30.0, [hidden = hidden](const Daemon& daemon) {
            CHECK(daemon.engine().size() == 1);
            CHECK(daemon.frame().sprites.empty() == hidden);
        });
        recorded.look(61.0, [](const Daemon& daemon) {
            CHECK(daemon.frame().sprites.size() == 1);
        });
        recorded.run();
    }
}

TEST_CASE("the notice for newcomers comes once in the life of a profile") {
    RecordedDaemon first(1.0);
    first.config(no_pets);
    first.run();
    CHECK(first.desktop.greetings().size() == 1);
    RecordedDaemon second(1.0);
    second.config(no_pets);
    second.folder.write("state.json", state_of(first));
    second.run();
    CHECK(second.desktop.greetings().empty());
}

TEST_CASE("a broken memory is forgotten, config.json is left as it is") {
    RecordedDaemon recorded(3.0);
    recorded.config(one_pet);
    recorded.folder.write("state.json", "{\"hidden\": tru");
    recorded.look(1.0, [](const Daemon& daemon) { CHECK(daemon.frame().sprites.size() == 1); });
    recorded.at(2.0, Request{request::SetQuiet{true}});
    recorded.run();
    CHECK(state_of(recorded).contains("\"quiet\": true"));
    CHECK(read_text_file(recorded.folder.path() / "config.json", 1U << 20U).value() == one_pet);
}

TEST_CASE("quiet: pets settle, scripts may not move them nor spawn any, the hand may") {
    RecordedDaemon recorded(12.0);
    recorded.config(R"({"pets": {"start": [{"x": 900, "y": 0, "vx": 800}]}})");
    recorded.script("busy.lua", R"(
        hyrax.every(0.1, function()
            hyrax.spawn{ x = 5, y = 5 }
            for _, pet in ipairs(hyrax.pets()) do pet:fling(500, -500) end
        end)
    )");
    recorded.requests = {request::SetQuiet{true}};
    recorded.look(7.0, [&](const Daemon& daemon) {
        CHECK(daemon.engine().size() == 1);
        CHECK(only_pet(daemon).motion == Motion::settled);
        CHECK(only_pet(daemon).position().x == doctest::Approx(900.0).epsilon(0.03));
        CHECK(recorded.desktop.statuses().back().quiet);
        const Rect bounds = daemon.frame().sprites.at(0).bounds();
        const Point middle{bounds.x + bounds.width / 2, bounds.y + bounds.height / 2};
        const Ticks time = from_seconds(7.1);
        recorded.desktop.add({time, input::Pressed{middle, Button::left, time}});
    });
    recorded.look(7.2, [](const Daemon& daemon) {
        CHECK(only_pet(daemon).motion == Motion::held);
    });
    recorded.at(7.5, input::PointerLost{});
    recorded.at(8.0, Request{request::SetQuiet{false}});
    recorded.look(9.0, [](const Daemon& daemon) { CHECK(daemon.engine().size() > 5); });
    recorded.run();
    CHECK_FALSE(state_of(recorded).contains("quiet"));
}

TEST_CASE("quiet by config, and the menu's word against it") {
    RecordedDaemon recorded(4.0);
    recorded.config(R"({"overlay": {"quiet": true}, "pets": {"start": []}})");
    recorded.script("spawn.lua", "hyrax.after(2, function() hyrax.spawn{} end) hyrax.spawn{}");
    recorded.look(1.0, [](const Daemon& daemon) { CHECK(daemon.engine().size() == 0); });
    recorded.at(1.5, Request{request::SetQuiet{false}});
    recorded.look(3.0, [](const Daemon& daemon) { CHECK(daemon.engine().size() == 1); });
    recorded.run();
    CHECK(state_of(recorded).contains("\"quiet\": false"));
}

TEST_CASE("pets leave a monitor that the user takes from them, and the menu says so") {
    RecordedDaemon recorded(8.0, two);
    recorded.config(R"({"pets": {"start": [{"x": 2500, "y": 400}]}})");
    recorded.at(2.0, Request{request::SetMonitor{"the right one", false}});
    recorded.look(3.0, [](const Daemon& daemon) {
        CHECK(only_pet(daemon).position().x < 1920.0);
        CHECK(daemon.engine().arena().boxes() == std::vector<Rect>{{0, 0, 1920, 1080}});
    });
    recorded.at(3.5, input::MenuWanted{});
    recorded.look(4.0, [&](const Daemon&) {
        CHECK_FALSE(is_ticked(recorded.desktop.menus().back(), "&1: 1280 x 1024"));
        CHECK(state_of(recorded).contains("\"the right one\": false"));
    });
    recorded.at(4.5, Request{request::SetMonitor{"nowhere", false}});
    recorded.at(5.0, Request{request::SetMonitor{"the right one", true}});
    recorded.look(6.0, [&](const Daemon& daemon) {
        CHECK(daemon.engine().arena().boxes().size() == 2);
        CHECK_FALSE(state_of(recorded).contains("the right one"));
    });
    recorded.run();
}

TEST_CASE("an allowed area is the arena, at once when the config changes") {
    RecordedDaemon recorded(6.0, two);
    recorded.config(R"({"overlay": {"allowed_area": [100, 200, 600, 500]},
                        "pets": {"start": [{"x": 1500, "y": 0}]}})");
    recorded.look(3.0, [](const Daemon& daemon) {
        CHECK(daemon.engine().arena().boxes() == std::vector<Rect>{{100, 200, 600, 500}});
        CHECK(only_pet(daemon).position().x < 700.0);
    });
    recorded.change_file(3.5, "config.json", R"({"overlay": {"allowed_monitors": [2]}})");
    recorded.look(4.0, [](const Daemon& daemon) {
        CHECK(daemon.engine().arena().boxes() == std::vector<Rect>{{1920, 0, 1280, 1024}});
    });
    recorded.change_file(4.5, "config.json", R"({"overlay": {"allowed_monitors": [7]}})");
    recorded.look(5.0, [&](const Daemon& daemon) {
        CHECK(daemon.engine().arena().boxes().size() == 2);
        CHECK(recorded.desktop.statuses().back().problem.contains("allowed_monitors"));
    });
    recorded.run();
}

TEST_CASE("gather calls pets to the monitor under the pointer, else to the primary one") {
    RecordedDaemon recorded(10.0, two);
    recorded.config(R"({"pets": {"start": [{"x": 10, "y": 400, "count": 3}]}})");
    recorded.look(1.0, [&](const Daemon&) { recorded.desktop.set_pointer({2500, 300}); });
    recorded.at(2.0, Request{request::Hide{}});
    recorded.at(3.0, Request{request::Gather{}});
    recorded.look(3.1, [&](const Daemon& daemon) {
        CHECK_FALSE(recorded.desktop.statuses().back().hidden);
        daemon.engine().for_each([](PetId, const Pet& pet) {
            CHECK(pet.position().x >= 1920.0);
            CHECK(pet.position().y < 100.0);
        });
        recorded.desktop.set_pointer({-4000, 0});
    });
    recorded.at(6.0, Request{request::Gather{}});
    recorded.look(6.1, [](const Daemon& daemon) {
        daemon.engine().for_each([](PetId, const Pet& pet) { CHECK(pet.position().x < 1920.0); });
    });
    recorded.run();
}

TEST_CASE("a script that is switched off stops, and starts again at a later day") {
    RecordedDaemon recorded(8.0);
    recorded.config(no_pets);
    recorded.script("a.lua", "hyrax.every(0.5, function() hyrax.spawn{} end)");
    recorded.script("b.lua", "hyrax.log.info('b')");
    std::size_t pets = 0;
    recorded.at(2.2, Request{request::SetScript{"a.lua", false}});
    recorded.look(2.5, [&](const Daemon& daemon) { pets = daemon.engine().size(); });
    recorded.look(5.0, [&](const Daemon& daemon) {
        CHECK(pets > 0);
        CHECK(daemon.engine().size() == pets);
        CHECK(state_of(recorded).contains("\"a.lua\""));
    });
    recorded.at(5.1, Request{request::SetScript{"none.lua", false}});
    recorded.at(5.2, Request{request::SetScript{"a.lua", true}});
    recorded.look(7.5, [&](const Daemon& daemon) {
        CHECK(daemon.engine().size() > pets);
        CHECK_FALSE(state_of(recorded).contains("a.lua"));
    });
    recorded.run();
}
