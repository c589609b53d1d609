// SPDX-License-Identifier: MIT
// Scripts in the whole daemon: what they keep, say, meet, and how their errors are seen.
#include "daemon/headless/testing_host.h"
#include "tests/headless/recorded_daemon.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace hyrax;

namespace {

constexpr auto no_pets = R"({"pets": {"start": []}})";

std::size_t pets_of(const Daemon& daemon) {
    return daemon.engine().size();
}

}  // namespace

TEST_CASE("what a script keeps is there at the next start, what unload keeps included") {
    RecordedDaemon recorded(2.0);
    recorded.config(no_pets);
    recorded.folder.write("store/keep.lua.json", R"({"starts": 41})");
    recorded.script("keep.lua", R"(
        hyrax.store.set("starts", hyrax.store.get("starts", 0) + 1)
        hyrax.every(0.01, function() hyrax.store.set("ticks", hyrax.now()) end)
        hyrax.on("unload", function(reason) hyrax.store.set("reason", reason) end)
    )");
    recorded.look(0.5, [&](const Daemon&) {
        CHECK(recorded.folder.read("store/keep.lua.json").contains("42"));
    });
    recorded.run();
    const std::string kept = recorded.folder.read("store/keep.lua.json");
    CHECK(kept.contains("\"reason\": \"exit\""));
    CHECK(kept.contains("\"starts\": 42"));
}

TEST_CASE("what scripts keep is written at once when the session ends, and once") {
    RecordedDaemon recorded(4.0);
    recorded.config(no_pets);
    recorded.script("keep.lua", R"(
        hyrax.on("unload", function()
            hyrax.store.set("ends", hyrax.store.get("ends", 0) + 1)
        end)
    )");
    recorded.desktop
        .add({from_seconds(2.0), input::Released{.at = {}, .button = Button::middle}, [&] {
                  recorded.daemon->end();
                  const std::string kept = recorded.folder.read("store/keep.lua.json");
                  CHECK(kept.contains("\"ends\": 1"));
              }});
    recorded.run();
    CHECK(recorded.folder.read("store/keep.lua.json").contains("\"ends\": 1"));
    CHECK(recorded.desktop.now() < from_seconds(2.5));
}

TEST_CASE("a script that keeps nothing leaves no file") {
    RecordedDaemon recorded(1.0);
    recorded.config(no_pets);
    recorded.script("idle.lua", "print(hyrax.store.get('x'))");
    recorded.run();
    CHECK_FALSE(std::filesystem::exists(recorded.folder.path() / "store"));
}

TEST_CASE("a pet walks where it is sent, speaks above itself, and then nothing wakes") {
    RecordedDaemon recorded(120.0);
    recorded.config(no_pets);
    recorded.script("walk.lua", R"(
        local pet = hyrax.spawn{ x = 500, y = 900, scale = 0.5 }
        pet:walk_to(900, 200)
        hyrax.after(4, function() pet:say("a speech that needs more than one line of text", 2) end)
    )");
    recorded.look(3.0, [](const Daemon& daemon) {
        daemon.engine().for_each([](PetId, const Pet& pet) {
            CHECK(pet.motion == Motion::walking);
            CHECK(pet.scale == 0.5);
        });
        CHECK(daemon.frame().bubbles.empty());
    });
    recorded.look(5.0, [](const Daemon& daemon) {
        REQUIRE(daemon.frame().bubbles.size() == 2);
        const Sprite& bubble = daemon.frame().bubbles[0];
        CHECK(bubble.bounds().bottom() < daemon.frame().sprites[0].bounds().bottom());
        CHECK(bubble.bounds().height > 2 * 14);
    });
    recorded.look(8.0, [](const Daemon& daemon) {
        CHECK(daemon.frame().bubbles.empty());
        daemon.engine().for_each([](PetId, const Pet& pet) {
            CHECK(pet.position().x == 900.0);
            CHECK_FALSE(pet.awake);
        });
    });
    std::size_t woken = 0;
    recorded.look(80.0, [&](const Daemon&) { woken = recorded.desktop.timer_wakeups(); });
    recorded.run();
    CHECK(recorded.desktop.timer_wakeups() <= woken + 1);
}

TEST_CASE("a picture shows pets, and bubbles above them") {
    Image red(Size{4, 4});
    Image blue(Size{4, 2});
    std::ranges::fill(red.pixels, 0xFFFF0000U);
    std::ranges::fill(blue.pixels, 0xFF0000FFU);
    const Frame frame{
        .sprites = {{red, {10, 10}, {}}},
        .bubbles = {{blue, {10, 9}, {}}},
    };
    const Image image = picture(frame, {screen({0, 0, 40, 30})});
    CHECK(image.at(11, 9) == 0xFF0000FFU);
    CHECK(image.at(11, 10) == 0xFF0000FFU);
    CHECK(image.at(11, 11) == 0xFFFF0000U);
    CHECK(image.at(20, 20) == 0);
}

TEST_CASE("pets that meet are told to who listens") {
    RecordedDaemon recorded(4.0);
    recorded.config(R"({"pets": {"start": []}, "physics": {"gravity": 0, "air_drag": 1}})");
    recorded.script("meet.lua", R"(
        hyrax.spawn{ x = 100, y = 300, vx = 300, tag = "a" }
        hyrax.spawn{ x = 900, y = 300, vx = -300, tag = "b" }
        hyrax.on("collide", function(a, b, speed)
            assert(math.abs(speed - 600) < 1e-6)
            a.tag, b.tag = a.tag .. "!", b.tag .. "!"
        end)
    )");
    recorded.run();
    std::string tags;
    recorded.daemon->engine().for_each([&tags](PetId, const Pet& pet) { tags += pet.tag; });
    CHECK(tags == "a!b!");
}

TEST_CASE("an error is one line in the status until the script is loaded again") {
    RecordedDaemon recorded(3.0);
    recorded.config(no_pets);
    recorded.script("bad.lua", "hyrax.every(0.1, function()\n error('oh no') end)");
    recorded.look(0.5, [&](const Daemon&) {
        REQUIRE_FALSE(recorded.desktop.statuses().empty());
        CHECK(recorded.desktop.statuses().back().problem == "bad.lua:2: oh no");
    });
    recorded.change_file(1.0, "scripts/bad.lua", "hyrax.spawn()");
    recorded.look(1.5, [](const Daemon& daemon) { CHECK(pets_of(daemon) == 1); });
    recorded.run();
    CHECK(recorded.desktop.statuses().back().problem == "");
}

TEST_CASE("a report of tests is TAP and fails for every reason there is") {
    TestReport report;
    CHECK_FALSE(report.passed());
    CHECK(tap(report).contains("1..0\n# no case"));
    report.ended = {{"a.lua", "one", "", 1.5}, {"a.lua", "two", "", 0.0}};
    CHECK(report.passed());
    CHECK(tap(report) == "ok 1 - one # 1.50 s\nok 2 - two # 0.00 s\n1..2\n");
    report.open = 1;
    CHECK_FALSE(report.passed());
    CHECK(tap(report).contains("1..3\n# 1 cases did not end in time"));
    report.open = 0;
    report.ended[1].problem = "a.lua:3: wrong";
    CHECK_FALSE(report.passed());
    CHECK(tap(report).contains("not ok 2 - two # 0.00 s\n# a.lua:3: wrong\n"));
}
