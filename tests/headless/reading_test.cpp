// SPDX-License-Identifier: MIT
// The whole daemon while pictures are being read, which takes a second here.
#include "tests/headless/recorded_daemon.h"

#include <doctest/doctest.h>

#include <filesystem>

using namespace hyrax;

namespace {

namespace fs = std::filesystem;

constexpr const char* spawner = "hyrax.every(0.1, function() hyrax.spawn{} end)";

/// A daemon whose sprites change at 2 s, and are there at 3 s.
struct SlowReader : RecordedDaemon {
    explicit SlowReader(double seconds) : RecordedDaemon(seconds) {
        config(R"({"pets": {"start": [], "max": 1000}})");
        desktop.set_reading_time(ticks_per_second);
        change_sprites(2.0);
    }
    /// Each time a kind more.
    void change_sprites(double at) {
        desktop.add({from_seconds(at), input::FilesChanged{}, [this] {
                         const fs::path sprites = folder.path() / "sprites";
                         fs::create_directories(sprites);
                         fs::copy(
                             fs::path(HYRAX_SOURCE_DIR) / "config" / "sprites" / "hyrax",
                             sprites / ("kind" + std::to_string(++kinds))
                         );
                     }});
    }
    std::size_t known() const { return daemon->engine().kinds().size(); }
    std::size_t pets() const { return daemon->engine().size(); }

    int kinds = 0;
};

}  // namespace

TEST_CASE("reading: a script that comes with a kind starts when the kind is there") {
    SlowReader recorded(6.0);
    recorded.change_file(2.0, "scripts/late.lua", "hyrax.spawn{ kind = 'kind1' }");
    recorded.look(2.9, [&](const Daemon&) { CHECK(recorded.pets() == 0); });
    recorded.look(3.5, [&](const Daemon& daemon) {
        CHECK(recorded.pets() == 1);
        CHECK(daemon.status().problem.empty());
    });
    recorded.run();
}

TEST_CASE("reading: what the user turns off meanwhile is off at once, and on again afterwards") {
    SlowReader recorded(8.0);
    recorded.script("spawn.lua", spawner);
    std::size_t pets = 0;
    recorded.at(2.2, Request{request::SetScript{"spawn.lua", false}});
    recorded.look(2.4, [&](const Daemon&) {
        pets = recorded.pets();
        CHECK(recorded.known() == 2);  // The answer waits for nothing.
    });
    recorded.look(4.0, [&](const Daemon&) { CHECK(recorded.pets() == pets); });
    recorded.at(4.0, Request{request::SetScript{"spawn.lua", true}});
    recorded.look(5.0, [&](const Daemon&) { CHECK(recorded.pets() > pets + 5); });
    recorded.run();
    CHECK(pets > 10);
}

TEST_CASE("reading: a plugin that is turned off and on meanwhile spawns again") {
    SlowReader recorded(8.0);
    recorded.folder.write("plugins/own/plugin.json", R"({"manifest": 1, "id": "own", "name": "Own",
        "version": "1.0.0", "api": "1.0", "entry": "main.lua"})");
    recorded.folder.write("plugins/own/main.lua", spawner);
    const auto plugin = [](bool on) {
        return std::string(R"({"pets": {"start": [], "max": 1000}, "plugins": {"own": {"enabled": )"
               ) +
               (on ? "true}}}" : "false}}}");
    };
    recorded.change_file(2.2, "config.json", plugin(false));
    recorded.look(2.3, [&](const Daemon&) { CHECK(recorded.pets() == 0); });
    recorded.change_file(2.4, "config.json", plugin(true));
    recorded.look(2.1, [&](const Daemon&) { CHECK(recorded.pets() > 10); });
    recorded.run();
    CHECK(recorded.pets() > 10);
}

TEST_CASE("reading: sprites that change again and again come nevertheless") {
    SlowReader recorded(12.0);
    for (double at = 2.9; at < 9.0; at += 0.9) {
        recorded.change_sprites(at);
    }
    recorded.look(6.5, [&](const Daemon&) { CHECK(recorded.known() > 2); });
    recorded.run();
    CHECK(recorded.known() == static_cast<std::size_t>(recorded.kinds) + 1);
}

TEST_CASE("reading: who is hidden in the moment the pictures come is hidden") {
    SlowReader recorded(6.0);
    recorded.config(R"({"pets": {"start": [{"x": 300, "y": 100}]}})");
    recorded.at(3.0, Request{request::Hide{}});
    recorded.look(2.9, [&](const Daemon&) {
        CHECK(recorded.desktop.last_frame().sprites.size() == 1);
    });
    recorded.run();
    CHECK(recorded.known() == 2);
    CHECK(recorded.desktop.last_frame().sprites.empty());
}

TEST_CASE("reading: reload is done with all of it before it is answered") {
    SlowReader recorded(6.0);
    recorded.desktop.add({from_seconds(2.2), Request{request::Reload{}}, [&] {
                              recorded.folder.write(
                                  "scripts/late.lua", "hyrax.spawn{ kind = 'kind1' }"
                              );
                          }});
    recorded.look(2.3, [&](const Daemon& daemon) {
        CHECK(recorded.known() == 2);
        CHECK(daemon.script_states().size() == 1);
    });
    // More sprites come while nobody waits any more for the first reading.
    recorded.change_sprites(2.6);
    recorded.run();
    CHECK(recorded.pets() == 1);
    CHECK(recorded.known() == 3);
}
