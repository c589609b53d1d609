// SPDX-License-Identifier: MIT
// Whatever lies in the profile, the daemon runs and says what is wrong.
#include "tests/headless/recorded_daemon.h"

#include <doctest/doctest.h>

#include <filesystem>

using namespace hyrax;

namespace {

// Runs for a second on the profile and returns the problem that the tray shows.
std::string problem_of(RecordedDaemon& recorded) {
    recorded.run();
    CHECK(recorded.daemon->engine().size() == 1);
    REQUIRE_FALSE(recorded.desktop.statuses().empty());
    return recorded.desktop.statuses().back().problem;
}

std::string problem_with_config(std::string_view text) {
    RecordedDaemon recorded(1.0);
    recorded.config(text);
    return problem_of(recorded);
}

}  // namespace

TEST_CASE("a config that is missing, empty or a folder") {
    RecordedDaemon missing(1.0);
    CHECK(problem_of(missing).contains("config.json"));

    CHECK(problem_with_config("").contains("config.json"));

    RecordedDaemon folder(1.0);
    std::filesystem::create_directories(folder.folder.path() / "config.json");
    CHECK(problem_of(folder).contains("config.json"));
}

TEST_CASE("a config of 100 MB is refused unread") {
    RecordedDaemon huge(1.0);
    huge.config("{}");
    std::filesystem::resize_file(huge.folder.path() / "config.json", 100U << 20U);
    CHECK(problem_of(huge).contains("config.json"));
}

TEST_CASE("a config that is not UTF-8, not JSON, or nested 10 000 deep") {
    CHECK(problem_with_config("{\"log\": {\"level\": \"\xff\xfe\"}}").contains("config.json:1:"));
    CHECK(problem_with_config("hello").contains("config.json:1:1"));
    CHECK(problem_with_config(std::string(10'000, '[')).contains("config.json:1:"));
}

TEST_CASE("a wrong value names file, line, column, key, what was expected and what was found") {
    const std::string problem =
        problem_with_config("{\n  \"physics\": {\n    \"restitution\": 1.5\n  }\n}");
    CHECK(problem.contains("config.json:3:20: /physics/restitution: "));
    CHECK(problem.contains("from 0 to 1"));
    CHECK(problem.contains("1.5"));
}

TEST_CASE("no monitor: the daemon waits for one") {
    RecordedDaemon recorded(3.0, {});
    recorded.config("{}");
    recorded.desktop.add({
        from_seconds(1.0),
        input::MonitorsChanged{},
        [&] { recorded.desktop.set_monitors({screen({0, 0, 800, 600})}); },
    });
    recorded.look(0.5, [](const Daemon& daemon) { CHECK(daemon.engine().size() == 0); });
    recorded.run();
    CHECK(recorded.daemon->engine().size() == 1);
}

TEST_CASE("a sprite set whose picture is missing or broken: a plain pet takes its place") {
    RecordedDaemon recorded(1.0);
    recorded.config("{}");
    recorded.folder.write("sprites/hyrax/sprite.json", recorded.folder.read("nothing"));
    CHECK(problem_of(recorded).contains("sprite.json"));
    CHECK(recorded.desktop.last_frame().sprites.size() == 1);

    const std::filesystem::path shipped =
        std::filesystem::path(HYRAX_SOURCE_DIR) / "config" / "sprites" / "hyrax";
    RecordedDaemon missing(1.0);
    missing.config("{}");
    std::filesystem::create_directories(missing.folder.path() / "sprites" / "hyrax");
    std::filesystem::copy(shipped / "sprite.json", missing.folder.path() / "sprites" / "hyrax");
    CHECK(problem_of(missing).contains("sheet.png"));

    RecordedDaemon broken(1.0);
    broken.config("{}");
    broken.folder.write("sprites/hyrax/sheet.png", "this is no picture");
    std::filesystem::copy(shipped / "sprite.json", broken.folder.path() / "sprites" / "hyrax");
    CHECK(problem_of(broken).contains("sheet.png"));
}

TEST_CASE("a script with a syntax error does not stop the others") {
    RecordedDaemon recorded(1.0);
    recorded.config(R"({"pets": {"start": []}})");
    recorded.script("broken.lua", "local x = = 1");
    recorded.script("fine.lua", "hyrax.spawn{}");
    recorded.run();
    CHECK(recorded.daemon->engine().size() == 1);
}

TEST_CASE("a script that never ends is stopped, and the daemon goes on") {
    RecordedDaemon recorded(1.0);
    recorded.config("{}");
    recorded.script("loop.lua", "while true do end");
    recorded.run();
    CHECK(recorded.daemon->engine().size() == 1);
    CHECK(recorded.desktop.now() == from_seconds(1.0));
}
