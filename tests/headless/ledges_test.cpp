// SPDX-License-Identifier: MIT
// The whole daemon and other programs' windows.
#include "tests/headless/recorded_daemon.h"

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

using namespace hyrax;

namespace {

Vec2 feet(const Daemon& daemon) {
    const Pet& pet = only_pet(daemon);
    return pet.position() + Vec2{0.0, daemon.engine().kinds()[pet.kind].box.height * 1.0};
}

// A pet above one window.
void prepare(RecordedDaemon& recorded, std::string_view windows) {
    recorded.config(R"({"overlay": {"ledges": "all"}, "pets": {"start": [{"x": 700, "y": 100}]}})");
    recorded.desktop.set_windows(*parse_windows(windows, "windows"));
}

}  // namespace

TEST_CASE("daemon ledges: a pet lands on a window, is carried, and falls when it closes") {
    RecordedDaemon recorded(30.0);
    prepare(recorded, R"(
        0,7,600,500,400,300
        10,7,640,450,400,300
        10.03,7,660,400,400,300
        20)");
    recorded.look(9.0, [](const Daemon& daemon) {
        CHECK(feet(daemon) == Vec2{700.0, 500.0});
        CHECK(only_pet(daemon).motion == Motion::settled);
        CHECK_FALSE(daemon.engine().moving());
    });
    recorded.look(11.0, [](const Daemon& daemon) {
        CHECK(feet(daemon) == Vec2{760.0, 400.0});
        CHECK_FALSE(daemon.engine().moving());
        CHECK(daemon.frame().sprites.size() == 1);
    });
    recorded.look(20.5, [](const Daemon& daemon) {
        CHECK(only_pet(daemon).motion == Motion::airborne);
    });
    recorded.run();
    CHECK(feet(*recorded.daemon) == Vec2{760.0, 1080.0});
}

TEST_CASE("daemon ledges: a pet on a window costs no wake-up, on the floor not even an interest") {
    RecordedDaemon recorded(1000.0);
    prepare(recorded, R"(
        0,7,600,500,400,300
        500
        600,7,600,500,400,300
        700)");
    std::size_t wakeups = 0;
    std::size_t presents = 0;
    recorded.look(60.0, [&](const Daemon&) {
        CHECK(recorded.desktop.interest() == WindowInterest{true, {7}});
        wakeups = recorded.desktop.timer_wakeups();
        presents = recorded.desktop.presents();
    });
    recorded.look(499.0, [&](const Daemon&) {
        // The look itself, and the frame after it.
        CHECK(recorded.desktop.timer_wakeups() <= wakeups + 1);
        CHECK(recorded.desktop.presents() <= presents + 1);
    });
    recorded.look(560.0, [&](const Daemon& daemon) {
        CHECK(feet(daemon).y == 1080.0);
        CHECK(recorded.desktop.interest() == WindowInterest{});
        wakeups = recorded.desktop.timer_wakeups();
    });
    recorded.run();
    CHECK(recorded.desktop.timer_wakeups() <= wakeups + 1);
}

TEST_CASE("daemon ledges: off, nobody asks for windows") {
    RecordedDaemon recorded(10.0);
    prepare(recorded, "0,7,600,500,400,300");
    recorded.config(R"({"pets": {"start": [{"x": 700, "y": 100}]}})");
    recorded.look(1.0, [&](const Daemon& daemon) {
        CHECK(recorded.desktop.interest() == WindowInterest{});
        CHECK(daemon.engine().ledges().empty());
    });
    recorded.run();
    CHECK(feet(*recorded.daemon).y == 1080.0);
}

TEST_CASE("daemon ledges: active takes the foreground window alone, and config changes it") {
    RecordedDaemon recorded(30.0);
    prepare(recorded, R"(
        0,7,600,500,400,300
        0,8,600,900,400,150,active)");
    recorded.config(
        R"({"overlay": {"ledges": "active"}, "pets": {"start": [{"x": 700, "y": 100}]}})"
    );
    recorded.look(9.0, [](const Daemon& daemon) { CHECK(feet(daemon).y == 900.0); });
    recorded.change_file(10.0, "config.json", R"({"overlay": {"ledges": "off"}})");
    recorded.look(20.0, [&](const Daemon& daemon) {
        CHECK(feet(daemon).y == 1080.0);
        CHECK(recorded.desktop.interest() == WindowInterest{});
    });
    recorded.run();
}

TEST_CASE("daemon ledges: who slept while windows changed falls past the old ones") {
    RecordedDaemon recorded(40.0);
    prepare(recorded, R"(
        0,7,0,500,100,300
        15,7,600,300,400,300)");
    recorded.script("jump.lua", R"(
        hyrax.after(20, function() hyrax.pets{ all = true }[1]:fling(0, -1500) end)
    )");
    recorded.look(10.0, [&](const Daemon& daemon) {
        CHECK(feet(daemon).y == 1080.0);
        CHECK(recorded.desktop.interest() == WindowInterest{});
    });
    recorded.run();
    CHECK(feet(*recorded.daemon).y == 300.0);
}

TEST_CASE("daemon ledges: a pause holds pets in the air, and what happened meanwhile counts") {
    RecordedDaemon recorded(40.0);
    prepare(recorded, R"(
        0,7,600,500,400,300
        15)");
    recorded.at(10.0, Request{request::SetPaused{true}});
    recorded.look(20.0, [&](const Daemon& daemon) {
        CHECK(recorded.desktop.interest() == WindowInterest{});
        CHECK(feet(daemon).y == 500.0);
    });
    recorded.at(25.0, Request{request::SetPaused{false}});
    recorded.run();
    CHECK(feet(*recorded.daemon).y == 1080.0);
}
