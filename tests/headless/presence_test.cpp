// SPDX-License-Identifier: MIT
// The whole daemon keeps out of the way: screens that are filled, sleep, batteries, calm.
#include "tests/headless/recorded_daemon.h"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

using namespace hyrax;

namespace {

constexpr Rect main_bounds{0, 0, 1920, 1080};
constexpr Rect side_bounds{1920, 0, 1280, 1024};

const std::vector<Monitor> two_monitors{
    {.bounds = main_bounds, .work = main_bounds, .primary = true, .name = "main"},
    {.bounds = side_bounds, .work = side_bounds, .name = "side"},
};

Facts filling(const Rect& bounds, std::string program = {}) {
    const FrontWindow window{
        .bounds = bounds, .window_class = "Player", .program = std::move(program)
    };
    return {.windows = {window}, .first_is_front = true};
}

void tell(RecordedDaemon& recorded, double seconds, const Facts& facts) {
    recorded.at(seconds, input::FactsChanged{facts, from_seconds(seconds)});
}

const Pet& pet_number(const Daemon& daemon, std::size_t number) {
    std::vector<const Pet*> pets;
    daemon.engine().for_each([&](PetId, const Pet& pet) { pets.push_back(&pet); });
    REQUIRE(pets.size() > number);
    return *pets[number];
}

}  // namespace

TEST_CASE("a film on one screen: its pets wait unseen, the others fly on") {
    RecordedDaemon recorded(20.0, two_monitors);
    recorded.config(R"({"pets": {"start": [{"x": 300, "y": 0}, {"x": 2300, "y": 0}]},
                        "physics": {"gravity": 100}})");
    Vec2 waiting;
    tell(recorded, 1.0, filling(side_bounds));
    recorded.look(1.25, [](const Daemon& daemon) { CHECK(daemon.frame().kept_free.empty()); });
    recorded.look(1.35, [&](const Daemon& daemon) {
        CHECK(daemon.frame().kept_free == std::vector{side_bounds});
        CHECK(recorded.desktop.conduct().front == Watch::closely);
        waiting = pet_number(daemon, 1).position();
        CHECK(waiting.y > 50.0);
    });
    recorded.look(3.0, [&](const Daemon& daemon) {
        CHECK(pet_number(daemon, 1).position() == waiting);
        CHECK(pet_number(daemon, 0).position().y > 300.0);
        CHECK(recorded.desktop.statuses().back().note.contains("fills the screen"));
    });
    tell(recorded, 4.0, {});
    recorded.look(4.95, [&](const Daemon& daemon) {
        CHECK(daemon.frame().kept_free == std::vector{side_bounds});
    });
    recorded.look(5.1, [&](const Daemon& daemon) {
        CHECK(daemon.frame().kept_free.empty());
        const double fallen = pet_number(daemon, 1).position().y - waiting.y;
        CHECK(fallen > 0.0);
        CHECK(fallen < 30.0);
    });
    recorded.run();
    CHECK(recorded.desktop.statuses().back().note.empty());
}

TEST_CASE("a film alone on the desk wakes the daemon for nothing") {
    RecordedDaemon recorded(600.0);
    recorded.config(R"({"pets": {"start": [{"x": 300, "y": 0}]}})");
    tell(recorded, 0.2, filling(main_bounds));
    std::size_t wakeups = 0;
    std::size_t presents = 0;
    // The only monitor of the recorded desktop has no taskbar.
    recorded.look(2.0, [&](const Daemon& daemon) {
        CHECK(daemon.frame().kept_free == std::vector{main_bounds});
        wakeups = recorded.desktop.timer_wakeups();
        presents = recorded.desktop.presents();
    });
    recorded.run();
    CHECK(recorded.desktop.timer_wakeups() <= wakeups + 1);
    CHECK(recorded.desktop.presents() == presents);
    CHECK(pet_number(*recorded.daemon, 0).position().y < 300.0);
}

TEST_CASE("a guarded program: no sprite anywhere, and the whole world waits") {
    RecordedDaemon recorded(30.0, two_monitors);
    recorded.config(R"({"pets": {"start": [{"x": 300, "y": 0}]},
        "overlay": {"fullscreen_rules": [{"exe": "guarded.exe", "do": "hide_everywhere"}]}})");
    recorded.script("timer.lua", "hyrax.after(5, function() hyrax.spawn{} end)");
    tell(recorded, 0.2, filling({10, 10, 300, 300}, "guarded.exe"));
    recorded.look(0.25, [&](const Daemon& daemon) {
        CHECK(daemon.frame().sprites.empty());
        CHECK(recorded.desktop.conduct().let_go);
        CHECK(recorded.desktop.conduct().name_programs);
        CHECK_FALSE(recorded.desktop.statuses().back().paused);
    });
    tell(recorded, 20.0, {});
    recorded.look(20.9, [](const Daemon& daemon) {
        CHECK(daemon.engine().size() == 1);
        CHECK(daemon.frame().sprites.empty());
    });
    recorded.look(21.1, [](const Daemon& daemon) {
        CHECK(daemon.frame().sprites.size() == 1);
        CHECK(pet_number(daemon, 0).position().y < 200.0);
    });
    recorded.run();
    CHECK(recorded.daemon->engine().size() == 2);
}

TEST_CASE("nothing happens in a locked session, and later all goes on or has gone on") {
    for (const bool catches_up : {false, true}) {
        CAPTURE(catches_up);
        RecordedDaemon recorded(5000.0);
        recorded.config(
            std::string(R"({"pets": {"start": [{"x": 300, "y": 0, "vx": 50}]},
            "physics": {"gravity": 0, "air_drag": 1, "restitution": 1},
            "overlay": {"on_resume": ")") +
            (catches_up ? "catch_up" : "go_on") + "\"}}"
        );
        tell(recorded, 1.0, {.locked = true});
        std::size_t wakeups = 0;
        std::size_t presents = 0;
        recorded.look(1.1, [&](const Daemon&) {
            wakeups = recorded.desktop.timer_wakeups();
            presents = recorded.desktop.presents();
        });
        recorded.look(1007.0, [&](const Daemon&) {
            CHECK(recorded.desktop.timer_wakeups() == wakeups);
            CHECK(recorded.desktop.presents() == presents);
            CHECK(recorded.desktop.conduct().front == Watch::off);
        });
        tell(recorded, 1007.0, {});
        recorded.look(1007.1, [&](const Daemon& daemon) {
            // From wall to wall and back takes 2 * (1920 - 108) px.
            const double way = 50.0 * (catches_up ? 1007.1 : 1.1);
            const double folded = std::fmod(300.0 + way, 2.0 * 1812.0);
            const double x = folded > 1812.0 ? 2.0 * 1812.0 - folded : folded;
            CHECK(std::fabs(pet_number(daemon, 0).position().x - x) < 2.0);
        });
        recorded.at(1008.0, Request{request::Quit{}});
        recorded.run();
    }
}

TEST_CASE("the laws that step do not catch up: they go on") {
    RecordedDaemon recorded(2000.0);
    recorded.config(R"({"pets": {"start": [{"x": 300, "y": 0, "vx": 50}]},
        "physics": {"integrator": "semi_implicit_euler_fixed", "gravity": 0, "air_drag": 1},
        "overlay": {"on_resume": "catch_up"}})");
    tell(recorded, 1.0, {.suspended = true});
    tell(recorded, 1001.0, {});
    recorded.look(1001.1, [](const Daemon& daemon) {
        CHECK(pet_number(daemon, 0).position().x == doctest::Approx(355.0).epsilon(0.02));
    });
    recorded.at(1002.0, Request{request::Quit{}});
    recorded.run();
}

TEST_CASE("fewer frames on battery, and the same flight") {
    const auto frames_and_place = [](const Facts& facts) {
        RecordedDaemon recorded(4.0);
        recorded.config(R"({"pets": {"start": [{"x": 0, "y": 0, "vx": 200}]},
            "physics": {"gravity": 0, "air_drag": 1}, "overlay": {"fps_on_battery": 20}})");
        tell(recorded, 0.0, facts);
        recorded.run();
        return std::pair(recorded.desktop.presents(), pet_number(*recorded.daemon, 0).position().x);
    };
    const auto [usual, place] = frames_and_place({});
    const auto [fewer, same_place] = frames_and_place({.on_battery = true});
    const auto [fewest, nearly_there] = frames_and_place({.remote_session = true});
    CHECK(usual == doctest::Approx(240).epsilon(0.02));
    CHECK(fewer == doctest::Approx(80).epsilon(0.05));
    CHECK(fewest == doctest::Approx(60).epsilon(0.05));
    // The last frame of each is up to a period old.
    CHECK(std::fabs(same_place - place) <= 200.0 / 20.0);
    CHECK(std::fabs(nearly_there - place) <= 200.0 / 15.0);
}

TEST_CASE("frames: as many as the screen shows that the pet is on") {
    std::vector<Monitor> monitors{screen({0, 0, 1000, 800}), screen({1000, 0, 1000, 800})};
    monitors[0].refresh_rate = 60;
    monitors[1].refresh_rate = 144;
    RecordedDaemon recorded(4.0, monitors);
    // It comes to the second screen after two seconds.
    recorded.config(R"({"pets": {"start": [{"x": 300, "y": 100, "vx": 320}]},
        "physics": {"gravity": 0, "air_drag": 1}, "overlay": {"fps": 240}})");
    std::size_t before = 0;
    recorded.look(1.5, [&](const Daemon&) { before = recorded.desktop.presents(); });
    std::size_t between = 0;
    recorded.look(2.5, [&](const Daemon&) { between = recorded.desktop.presents(); });
    recorded.run();
    CHECK(before == doctest::Approx(90).epsilon(0.05));
    CHECK(recorded.desktop.presents() - between == doctest::Approx(216).epsilon(0.05));
}

TEST_CASE("idle animations run at their own rate") {
    RecordedDaemon recorded(30.0);
    recorded.config(R"({"pets": {"start": [{"x": 300, "y": 900}], "drowsy_after": 60}})");
    std::size_t wakeups = 0;
    recorded.look(10.0, [&](const Daemon&) { wakeups = recorded.desktop.timer_wakeups(); });
    recorded.look(20.0, [&](const Daemon& daemon) {
        CHECK_FALSE(daemon.engine().moving());
        const std::size_t in_ten_seconds = recorded.desktop.timer_wakeups() - wakeups;
        CHECK(in_ten_seconds > 2);
        CHECK(in_ten_seconds < 120);
        CHECK(recorded.desktop.conduct().resting);
    });
    recorded.run();
}

TEST_CASE("with reduced motion pets sit still, scripts do not stir them, throws do") {
    RecordedDaemon recorded(60.0);
    recorded.config(R"({"pets": {"start": [{"x": 300, "y": 900}], "drowsy_after": 20}})");
    recorded.script("stir.lua", R"(
        hyrax.every(1, function()
            if hyrax.now() > 14 then return end
            for _, pet in ipairs(hyrax.pets{ all = true }) do pet:push(0, -500) end
        end)
    )");
    tell(recorded, 0.0, {.animations = false});
    std::size_t presents = 0;
    recorded.look(5.0, [&](const Daemon& daemon) {
        CHECK(pet_number(daemon, 0).motion == Motion::settled);
        CHECK(recorded.desktop.statuses().back().note.contains("reduced motion"));
        CHECK(recorded.desktop.conduct().front == Watch::events);
        presents = recorded.desktop.presents();
    });
    recorded.look(15.0, [&](const Daemon&) { CHECK(recorded.desktop.presents() == presents); });
    recorded.at(15.0, Request{request::FlingAll{}});
    recorded.look(15.2, [](const Daemon& daemon) {
        CHECK(pet_number(daemon, 0).motion == Motion::airborne);
    });
    recorded.run();
    CHECK(pet_number(*recorded.daemon, 0).motion == Motion::settled);
}

TEST_CASE("a refused exclusion from captures is told") {
    RecordedDaemon recorded(2.0);
    recorded.config(R"({"overlay": {"hide_from_capture": true}})");
    recorded.look(0.5, [&](const Daemon&) {
        CHECK(recorded.desktop.conduct().hide_from_capture);
        CHECK(recorded.desktop.statuses().back().problem.empty());
    });
    tell(recorded, 1.0, {.capture_refused = true});
    recorded.run();
    CHECK(recorded.desktop.statuses().back().problem.contains("hide_from_capture"));
}

TEST_CASE("where pets stand among all windows is told to the desktop, and told anew") {
    RecordedDaemon recorded(2.0);
    recorded.config(R"({"overlay": {"z": "bottom"}})");
    recorded.look(0.5, [&](const Daemon&) {
        CHECK(recorded.desktop.conduct().layer == Layer::bottom);
    });
    recorded.change_file(1.0, "config.json", R"({"overlay": {"z": "top"}})");
    recorded.run();
    CHECK(recorded.desktop.conduct().layer == Layer::top);
}

TEST_CASE("sleep is told late, when it is over, and costs the pets no time") {
    RecordedDaemon recorded(1002.0);
    recorded.config(R"({"pets": {"start": [{"x": 300, "y": 0, "vx": 50}]},
        "physics": {"gravity": 0, "air_drag": 1}})");
    const Ticks asleep = from_seconds(1.0);
    const Ticks awake = from_seconds(1001.0);
    // No frame in between: the machine sleeps, and with it the daemon.
    recorded.at(0.99, input::FactsChanged{{.display_off = true}, from_seconds(0.99)});
    recorded.at(1001.0, input::FactsChanged{{.suspended = true}, asleep});
    recorded.at(1001.0, input::FactsChanged{{}, awake});
    recorded.run();
    CHECK(std::fabs(pet_number(*recorded.daemon, 0).position().x - 400.0) < 3.0);
}
