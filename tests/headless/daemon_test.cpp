// SPDX-License-Identifier: MIT
#include "tests/headless/recorded_daemon.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

using namespace hyrax;

namespace {

constexpr std::string_view one_pet_in_the_middle = R"({
    // A comment, as people write them.
    "pets": {"start": [{"kind": "hyrax", "count": 1, "x": 900, "y": 400}], "drowsy_after": 1}
})";

constexpr std::string_view no_pets = R"({"pets": {"start": []}})";

bool knows(const Daemon& daemon, std::string_view kind) {
    return std::ranges::find(daemon.engine().kinds(), kind, &Kind::name) !=
           daemon.engine().kinds().end();
}

Point middle_of(const Frame& frame) {
    const Rect bounds = frame.sprites.at(0).bounds();
    return {bounds.x + bounds.width / 2, bounds.y + bounds.height / 2};
}

}  // namespace

TEST_CASE("start-up pets fall, rest, and then nothing wakes the daemon any more") {
    RecordedDaemon recorded(300.0);
    recorded.config(one_pet_in_the_middle);
    std::size_t wakeups_when_at_rest = 0;
    std::size_t presents_when_at_rest = 0;
    recorded.look(120.0, [&](const Daemon&) {
        wakeups_when_at_rest = recorded.desktop.timer_wakeups();
        presents_when_at_rest = recorded.desktop.presents();
    });
    recorded.run();
    CHECK(only_pet(*recorded.daemon).motion == Motion::settled);
    CHECK(wakeups_when_at_rest > 60);
    // One frame answers the look itself.
    CHECK(recorded.desktop.timer_wakeups() <= wakeups_when_at_rest + 1);
    CHECK(recorded.desktop.presents() == presents_when_at_rest);
}

TEST_CASE("a pet is grabbed, carried, thrown, and flies the way the hand moved") {
    RecordedDaemon recorded(6.0);
    recorded.config(one_pet_in_the_middle);
    Point grip;
    recorded.look(3.0, [&](const Daemon& daemon) {
        grip = middle_of(daemon.frame());
        for (int i = 0; i <= 20; ++i) {
            const Ticks time = from_seconds(3.1 + i * 0.01);
            const Point at{grip.x - 15 * i, grip.y - 20 * i};
            if (i == 0) {
                recorded.desktop.add({time, input::Pressed{at, Button::left, time}});
            } else {
                recorded.desktop.add({time, input::Moved{at, time}});
            }
        }
        const Ticks time = from_seconds(3.305);
        recorded.desktop.add(
            {time, input::Released{{grip.x - 300, grip.y - 400}, Button::left, time}}
        );
    });
    recorded.look(3.2, [&](const Daemon& daemon) {
        CHECK(only_pet(daemon).motion == Motion::held);
    });
    recorded.look(3.31, [&](const Daemon& daemon) {
        const Pet& pet = only_pet(daemon);
        CHECK(pet.motion == Motion::airborne);
        CHECK(pet.velocity().x == doctest::Approx(-1500.0).epsilon(0.05));
        CHECK(pet.velocity().y == doctest::Approx(-2000.0).epsilon(0.05));
    });
    recorded.look(3.5, [](const Daemon& daemon) { CHECK(only_pet(daemon).position().x < 500.0); });
    recorded.run();
}

TEST_CASE("a press beside every pet grabs nothing") {
    RecordedDaemon recorded(3.0);
    recorded.config(one_pet_in_the_middle);
    recorded.at(2.0, input::Pressed{{10, 10}, Button::left, from_seconds(2.0)});
    recorded.look(2.5, [&](const Daemon& daemon) {
        CHECK(only_pet(daemon).motion != Motion::held);
    });
    recorded.run();
}

TEST_CASE("losing the pointer drops the pet in place") {
    RecordedDaemon recorded(5.0);
    recorded.config(one_pet_in_the_middle);
    recorded.look(3.0, [&](const Daemon& daemon) {
        const Point at = middle_of(daemon.frame());
        const Ticks time = from_seconds(3.1);
        recorded.desktop.add({time, input::Pressed{at, Button::left, time}});
        recorded.desktop.add({time + 1, input::Moved{{at.x, at.y - 300}, time + 1}});
    });
    recorded.at(3.2, input::PointerLost{});
    recorded.look(3.21, [&](const Daemon& daemon) {
        CHECK(only_pet(daemon).motion == Motion::airborne);
        CHECK(only_pet(daemon).velocity() == Vec2{});
    });
    recorded.run();
}

TEST_CASE("saving config.json changes moving pets at once, a broken file keeps the last good one") {
    RecordedDaemon recorded(3.0);
    recorded.config(
        R"({"physics": {"gravity": 100, "air_drag": 1}, "pets": {"start": [{"x": 500, "y": 0}]}})"
    );
    recorded.change_file(0.5, "config.json", R"({"physics": {"gravity": 0, "air_drag": 1}})");
    double speed = 0.0;
    recorded.look(0.6, [&](const Daemon& daemon) {
        speed = only_pet(daemon).velocity().y;
        CHECK(speed == doctest::Approx(50.0).epsilon(0.1));
    });
    recorded.change_file(0.7, "config.json", R"({"physics": {"gravity": )");
    recorded.look(0.9, [&](const Daemon& daemon) {
        CHECK(only_pet(daemon).velocity().y == speed);
        REQUIRE_FALSE(recorded.desktop.statuses().empty());
        CHECK(recorded.desktop.statuses().back().problem.contains("config.json:1:"));
    });
    recorded.change_file(1.0, "config.json", R"({"physics": {"gravity": 500, "air_drag": 1}})");
    recorded.run();
    CHECK(only_pet(*recorded.daemon).position().y > 900.0);
    CHECK(recorded.desktop.statuses().back().problem.empty());
}

TEST_CASE("a script spawns and throws, and reads what became of it") {
    RecordedDaemon recorded(4.0);
    recorded.config(no_pets);
    recorded.script("throw.lua", R"(
        local pet = hyrax.spawn{ x = 800, y = 300, tag = "thrown" }
        pet:fling(-400, -200)
        hyrax.after(1, function()
            if pet.x < 800 then hyrax.spawn{ x = pet.x, y = 0, tag = "witness" } end
        end)
        hyrax.on("land", function(which, speed)
            if which == pet then pet.tag = "landed" end
        end)
    )");
    recorded.run();
    std::vector<std::string> tags;
    recorded.daemon->engine().for_each([&](PetId, const Pet& pet) { tags.push_back(pet.tag); });
    CHECK(tags == std::vector<std::string>{"landed", "witness"});
}

TEST_CASE("reset puts a script's pets back where they were spawned") {
    RecordedDaemon recorded(1.05);
    recorded.config(no_pets);
    recorded.script("back.lua", R"(
        hyrax.spawn{ x = 800, y = 300, vx = 500 }
        hyrax.after(1, function() hyrax.reset() end)
    )");
    recorded.run();
    CHECK(only_pet(*recorded.daemon).position().x == 800.0);
}

TEST_CASE("saving a script runs the new text, other files do not restart it") {
    RecordedDaemon recorded(3.0);
    recorded.config(no_pets);
    recorded.script("one.lua", "hyrax.spawn{ tag = 'old' }");
    recorded.change_file(1.0, "notes.txt", "hello");
    recorded.look(1.5, [](const Daemon& daemon) { CHECK(daemon.engine().size() == 1); });
    recorded.change_file(2.0, "scripts/one.lua", "hyrax.spawn{ tag = 'new' }");
    recorded.run();
    CHECK(recorded.daemon->engine().size() == 2);
}

TEST_CASE("pausing freezes pets and scripts, resuming goes on where they were") {
    RecordedDaemon recorded(20.0);
    recorded.config(R"({"pets": {"start": [{"x": 500, "y": 0}]}})");
    recorded.script("timer.lua", "hyrax.after(1, function() hyrax.spawn{} end)");
    recorded.at(0.5, Request{request::SetPaused{true}});
    Vec2 frozen;
    std::size_t wakeups = 0;
    recorded.look(0.6, [&](const Daemon& daemon) {
        frozen = only_pet(daemon).position();
        wakeups = recorded.desktop.timer_wakeups();
    });
    recorded.look(10.0, [&](const Daemon& daemon) {
        CHECK(daemon.engine().size() == 1);
        CHECK(only_pet(daemon).position() == frozen);
        CHECK(recorded.desktop.timer_wakeups() <= wakeups + 1);
    });
    recorded.at(10.1, Request{request::TogglePause{}});
    recorded.look(10.2, [&](const Daemon& daemon) {
        CHECK(only_pet(daemon).position().y - frozen.y > 10.0);
        CHECK(only_pet(daemon).position().y - frozen.y < 200.0);
    });
    recorded.run();
    CHECK(recorded.daemon->engine().size() == 2);
}

TEST_CASE("requests of the command line come after the start-up pets") {
    RecordedDaemon recorded(1.0);
    recorded.config(R"({"pets": {"start": [{"count": 2}]}})");
    recorded.requests = {Request{request::Spawn{.count = 3}}, Request{request::FlingAll{}}};
    recorded.run();
    CHECK(recorded.daemon->engine().size() == 5);
    CHECK(recorded.daemon->engine().moving());
}

TEST_CASE("remove all empties the desktop, reload keeps the pets") {
    RecordedDaemon recorded(4.0);
    recorded.config(R"({"pets": {"start": [{"count": 2}]}})");
    recorded.at(1.0, Request{request::Reload{}});
    recorded.look(2.0, [](const Daemon& daemon) {
        CHECK(daemon.engine().size() == 2);
        CHECK(daemon.frame().sprites.size() == 2);
    });
    recorded.at(3.0, Request{request::RemoveAll{}});
    recorded.run();
    CHECK(recorded.daemon->engine().size() == 0);
    CHECK(recorded.desktop.last_frame().sprites.empty());
}

TEST_CASE("monitors that go away for a moment change nothing; new ones are used") {
    RecordedDaemon recorded(5.0, {screen({0, 0, 800, 600}), screen({-800, 0, 800, 600})});
    recorded.config(R"({"pets": {"start": [{"x": -500, "y": 0}]}})");
    recorded.desktop.add({from_seconds(1.0), input::MonitorsChanged{}, [&] {
                              recorded.desktop.set_monitors({});
                          }});
    recorded.look(2.0, [](const Daemon& daemon) {
        CHECK(only_pet(daemon).position().x == -500.0);
    });
    recorded.desktop.add({
        from_seconds(3.0),
        input::MonitorsChanged{},
        [&] { recorded.desktop.set_monitors({screen({0, 0, 800, 600})}); },
    });
    recorded.run();
    CHECK(only_pet(*recorded.daemon).position().x == 0.0);
}

TEST_CASE("a frame that was lost is presented once more, though nothing changes in a pause") {
    RecordedDaemon recorded(60.0);
    recorded.config(one_pet_in_the_middle);
    std::uint64_t frames = 0;
    recorded.at(45.0, Request{request::SetPaused{true}});
    recorded.desktop.add({from_seconds(50.0), input::FrameLost{}, [&] {
                              frames = recorded.desktop.counters().overlay.frames;
                          }});
    recorded.run();
    CHECK(frames > 0);
    CHECK(recorded.desktop.counters().overlay.frames == frames + 1);
}

TEST_CASE("sprites are read again when their files change; what is broken stays as it was") {
    namespace fs = std::filesystem;
    const fs::path shipped = fs::path(HYRAX_SOURCE_DIR) / "config" / "sprites" / "hyrax";
    RecordedDaemon recorded(8.0);
    recorded.config(R"({"pets": {"start": [{"x": 300, "y": 100}]}})");
    const auto own = [&](const char* name) { return recorded.folder.path() / "sprites" / name; };
    // A new kind, and a hyrax of the user's own at twice the size.
    recorded.desktop.add({from_seconds(2.0), input::FilesChanged{}, [&] {
                              fs::create_directories(recorded.folder.path() / "sprites");
                              fs::copy(shipped, own("marmot"));
                              fs::copy(shipped, own("hyrax"));
                              std::string text = recorded.folder.read("sprites/hyrax/sprite.json");
                              text.insert(text.find('{') + 1, "\"scale\": 2,");
                              recorded.folder.write("sprites/hyrax/sprite.json", text);
                          }});
    recorded.look(3.0, [](const Daemon& daemon) {
        CHECK(knows(daemon, "marmot"));
        CHECK(only_pet(daemon).drawn_scale == 2.0);
    });
    recorded.change_file(4.0, "sprites/hyrax/sprite.json", "{ broken");
    recorded.look(5.0, [](const Daemon& daemon) {
        CHECK(only_pet(daemon).drawn_scale == 2.0);
        CHECK(daemon.status().problem.contains("sprite.json:1:"));
    });
    recorded.desktop.add({from_seconds(6.0), input::FilesChanged{}, [&] {
                              fs::remove_all(own("hyrax"));
                              fs::remove_all(own("marmot"));
                          }});
    recorded.run();
    CHECK_FALSE(knows(*recorded.daemon, "marmot"));
    CHECK(only_pet(*recorded.daemon).drawn_scale == 1.0);
    CHECK(recorded.daemon->status().problem.empty());
}

TEST_CASE("the same input gives the same trace, byte for byte") {
    const auto trace = [] {
        RecordedDaemon recorded(5.0);
        recorded.config(R"({"pets": {"start": [{"count": 5}]}})");
        recorded.script("shake.lua", R"(
            hyrax.every(0.5, function()
                for _, pet in ipairs(hyrax.pets{ all = true }) do pet:push(100, -300) end
            end)
        )");
        recorded.requests = {Request{request::FlingAll{}}};
        DaemonOptions options{
            .profile =
                {recorded.folder.path() / "config.json",
                 recorded.folder.path(),
                 HYRAX_SOURCE_DIR,
                 {}},
            .decode = decode_png,
            .scripts = make_script_host({}),
            .trace = std::move(*Trace::open(recorded.folder.path() / "trace.csv")),
            .requests = {},
            .fps = {},
        };
        Daemon(recorded.desktop, std::move(options)).run();
        return recorded.folder.read("trace.csv");
    };
    const std::string first = trace();
    CHECK(std::ranges::count(first, '\n') > 500);
    CHECK(first == trace());
}

TEST_CASE("every shipped example runs for a minute and keeps its pets in the arena") {
    for (const char* example : {"fountain", "juggling", "earthquake"}) {
        CAPTURE(example);
        RecordedDaemon recorded(
            60.0, {screen({0, 0, 1280, 720}), screen({-1024, -100, 1024, 768})}
        );
        recorded.config(
            std::string(R"({"pets": {"start": [{"count": 3}]}, "scripts": {"run": ["examples/)") +
            example + R"(.lua"]}})"
        );
        recorded.look(30.0, [](const Daemon& daemon) { CHECK(daemon.engine().size() >= 1); });
        recorded.run();
        CHECK(recorded.desktop.presents() > 600);
        CHECK(recorded.desktop.statuses().back().problem.empty());
        recorded.daemon->engine().for_each([&](PetId, const Pet& pet) {
            CHECK(std::isfinite(pet.position().x));
            const Engine& engine = recorded.daemon->engine();
            const FreeSpace space = engine.arena().space_for(engine.kinds()[pet.kind].box);
            CHECK(space.nearest(pet.position()) == pet.position());
        });
    }
}

TEST_CASE("the first window appears where the config wants it among others") {
    struct FirstLook : HeadlessDesktop {
        using HeadlessDesktop::HeadlessDesktop;
        void present(const Frame& frame) override {
            layers.push_back(conduct().layer);
            HeadlessDesktop::present(frame);
        }
        std::vector<Layer> layers;
    };
    const TemporaryFolder folder;
    folder.write("config.json", R"({"overlay": {"z": "bottom"}})");
    FirstLook desktop({screen({0, 0, 1920, 1080})}, ticks_per_second);
    DaemonOptions options{
        .profile = profile_in(folder),
        .decode = decode_png,
        .scripts = nullptr,
        .trace = {},
        .requests = {},
        .fps = {},
    };
    Daemon(desktop, std::move(options)).run();
    REQUIRE_FALSE(desktop.layers.empty());
    CHECK(std::ranges::count(desktop.layers, Layer::bottom) == std::ssize(desktop.layers));
}
