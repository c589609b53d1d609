// SPDX-License-Identifier: MIT
// Plugins in the whole daemon: found, asked about, loaded again, and gone.
#include "tests/headless/recorded_daemon.h"
#include "tests/support/png_header.h"

#include <doctest/doctest.h>

#include <string>

using namespace hyrax;

namespace {

const std::string manifest =
    R"({"manifest": 1, "id": "rock", "version": "1.0.0", "api": "1.0", "name": "Rock", )"
    R"("config": [{"key": "count", "type": "integer", "default": 2, "min": 1, "max": 9}])";

void add_plugin(const RecordedDaemon& run, const std::string& more = "") {
    run.config(R"({"pets": {"start": []}})");
    run.folder.write("plugins/rock/plugin.json", manifest + more + "}");
    run.folder.write("plugins/rock/main.lua", R"(
        for i = 1, hyrax.config.count do hyrax.spawn{ tag = require("tag") } end
    )");
    run.folder.write("plugins/rock/tag.lua", "return 'rocker'");
}

std::size_t pets_of(const Daemon& daemon, const std::string& owner) {
    std::size_t count = 0;
    daemon.engine().for_each([&](PetId, const Pet& pet) { count += pet.owner == owner ? 1U : 0U; });
    return count;
}

const PluginEntry& rock(const Daemon& daemon) {
    for (const PluginEntry& entry : daemon.plugins()) {
        if (entry.id == "rock") {
            return entry;
        }
    }
    FAIL("there is no plugin");
    return daemon.plugins().front();
}

void remove_plugin(RecordedDaemon& run, double seconds) {
    run.desktop.add({
        from_seconds(seconds),
        input::FilesChanged{},
        [&run] { std::filesystem::remove_all(run.folder.path() / "plugins"); },
    });
}

}  // namespace

TEST_CASE("a plugin of the user's runs, with its settings; when its folder goes, its pets leave") {
    RecordedDaemon run(4.0);
    add_plugin(run);
    run.look(1.0, [](const Daemon& daemon) {
        CHECK(pets_of(daemon, "rock") == 2);
        CHECK(daemon.status().problem.empty());
    });
    run.change_file(
        1.5, "config.json", R"({"pets": {"start": []}, "plugins": {"rock": {"count": 10}}})"
    );
    run.look(2.0, [](const Daemon& daemon) {
        CHECK(daemon.status().problem.contains("/plugins/rock/count: must be a whole number from 1")
        );
        CHECK(daemon.status().problem.ends_with("got 10; the default 2 is used"));
    });
    remove_plugin(run, 2.5);
    run.look(3.0, [](const Daemon& daemon) {
        CHECK(pets_of(daemon, "rock") == 0);
        CHECK(daemon.status().problem.ends_with("/plugins/rock: there is no such plugin"));
    });
    run.run();
}

TEST_CASE("what is saved broken keeps what ran; what is saved well takes its place") {
    RecordedDaemon run(6.0);
    add_plugin(run, R"(, "on_reload": "remove")");
    run.change_file(1.0, "plugins/rock/tag.lua", "return (");
    run.look(2.0, [](const Daemon& daemon) {
        CHECK(pets_of(daemon, "rock") == 2);
        CHECK(daemon.status().problem.contains("rock/tag.lua:1:"));
    });
    run.change_file(2.5, "plugins/rock/plugin.json", "{ broken");
    run.look(3.0, [](const Daemon& daemon) {
        CHECK(pets_of(daemon, "rock") == 2);
        CHECK(daemon.status().problem.contains("plugin.json:1:3:"));
    });
    run.change_file(3.5, "plugins/rock/plugin.json", manifest + R"(, "on_reload": "remove"})");
    run.change_file(4.0, "plugins/rock/tag.lua", "return 'other'");
    run.look(5.0, [](const Daemon& daemon) {
        CHECK(pets_of(daemon, "rock") == 2);
        daemon.engine().for_each([](PetId, const Pet& pet) { CHECK(pet.tag == "other"); });
        CHECK(daemon.status().problem.empty());
    });
    run.run();
}

TEST_CASE("a plugin that asks waits until it is allowed, and asks again for more") {
    RecordedDaemon run(8.0);
    add_plugin(run, R"(, "permissions": ["cursor"])");
    run.look(1.0, [](const Daemon& daemon) {
        CHECK(pets_of(daemon, "rock") == 0);
        CHECK(rock(daemon).state == PluginState::asks);
        CHECK(daemon.status().note.starts_with("plugin rock asks for: cursor"));
    });
    run.at(2.0, Request{request::AllowPlugin{"rock", true}});
    run.look(3.0, [](const Daemon& daemon) {
        CHECK(pets_of(daemon, "rock") == 2);
        CHECK(daemon.status().note.empty());
    });
    run.change_file(
        4.0, "plugins/rock/plugin.json", manifest + R"(, "permissions": ["cursor", "wind"]})"
    );
    run.look(5.0, [](const Daemon& daemon) {
        CHECK(pets_of(daemon, "rock") == 0);
        CHECK(rock(daemon).missing == std::vector<std::string>{"wind"});
    });
    run.at(6.0, Request{request::AllowPlugin{"rock", false}});
    run.look(7.0, [](const Daemon& daemon) { CHECK(rock(daemon).state == PluginState::off); });
    run.run();
    CHECK(run.folder.read("state.json").contains("\"rock\": false"));
    CHECK(run.folder.read("state.json").contains("\"granted\": {}"));
}

TEST_CASE("shipped plugins are off until they are turned on, and bring their kinds along") {
    RecordedDaemon run(4.0);
    run.config(R"({"pets": {"start": []}})");
    run.look(0.5, [](const Daemon& daemon) {
        CHECK(daemon.engine().size() == 0);
        CHECK(daemon.engine().kinds().size() == 1);
    });
    run.at(1.0, Request{request::SetPlugin{"catch", true}});
    run.look(2.0, [](const Daemon& daemon) {
        CHECK(pets_of(daemon, "catch") == 4);
        REQUIRE(daemon.engine().kinds().size() == 2);
        CHECK(daemon.engine().kinds()[1].name == "catch/basket");
        CHECK(daemon.status().problem.empty());
    });
    run.at(3.0, Request{request::SetPlugin{"catch", false}});
    run.look(3.5, [](const Daemon& daemon) {
        CHECK(daemon.engine().size() == 0);
        CHECK(daemon.engine().kinds().size() == 1);
    });
    run.run();
}

TEST_CASE("wind moves the pets by another integrator while it blows") {
    RecordedDaemon run(4.0);
    run.config(R"({"pets": {"start": [{}]}})");
    run.script("wind.lua", R"(
        hyrax.after(1, function() hyrax.wind(2000) end)
        hyrax.after(2, function() hyrax.wind() end)
    )");
    run.look(0.5, [](const Daemon& daemon) {
        CHECK(daemon.engine().integrator() == Integrator::event_driven);
    });
    run.look(1.5, [](const Daemon& daemon) {
        CHECK(daemon.engine().integrator() == Integrator::rk45);
    });
    run.look(2.5, [](const Daemon& daemon) {
        CHECK(daemon.engine().integrator() == Integrator::event_driven);
    });
    run.run();
}

TEST_CASE("a picture that is too large is told of; what ran before goes on") {
    RecordedDaemon run(3.0);
    add_plugin(run);
    run.change_file(1.0, "plugins/rock/huge.png", png_header(60'000, 60'000));
    run.look(2.0, [](const Daemon& daemon) {
        CHECK(daemon.status().problem.contains("huge.png: is 60000 x 60000 pixels; a plugin's"));
        CHECK(pets_of(daemon, "rock") == 2);
    });
    run.run();
}
