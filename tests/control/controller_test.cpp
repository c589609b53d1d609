// SPDX-License-Identifier: MIT
#include "daemon/control/controller.h"

#include "daemon/core/files.h"
#include "daemon/core/framing.h"
#include "tests/control/asked_daemon.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <string>

using namespace hyrax;
using nlohmann::json;

TEST_CASE("pets are spawned, chosen, listed, thrown and removed") {
    AskedDaemon daemon(5.0);
    daemon.at(1.0, R"({"do": "spawn", "count": 2, "x": 100, "y": 50, "tag": "party"})");
    daemon.at(1.0, R"({"do": "list", "tag": "party"})");
    daemon.at(1.0, R"({"do": "fling", "tag": "party", "vx": 300, "vy": -400})");
    daemon.at(1.0, R"({"do": "list", "pet": "1.1"})");
    daemon.at(1.5, R"({"do": "stop", "tag": "party"})");
    daemon.at(1.5, R"({"do": "list", "first": 1, "most": 1})");
    daemon.at(1.6, R"({"do": "reset", "pet": "1.1"})");
    daemon.at(1.6, R"({"do": "list", "pet": "1.1"})");
    daemon.at(1.7, R"({"do": "remove", "tag": "party"})");
    daemon.at(1.7, R"({"do": "list"})");
    daemon.at(1.7, R"({"do": "fling"})");
    daemon.run();
    CHECK(daemon.result(0) == json{{"pets", {"1.1", "2.1"}}});
    CHECK(daemon.result(1)["total"] == 2);
    CHECK(daemon.result(1)["pets"][0]["x"] == 100.0);
    CHECK(daemon.result(1)["pets"][0]["state"] == "airborne");
    CHECK(daemon.result(2) == json{{"pets", 2}});
    CHECK(daemon.result(3)["pets"][0]["vx"] == 300.0);
    CHECK(daemon.result(3)["pets"][0]["vy"] == -400.0);
    CHECK(daemon.result(5)["total"] == 3);
    CHECK(daemon.result(5)["pets"].size() == 1);
    CHECK(daemon.result(5)["pets"][0]["id"] == "1.1");
    CHECK(daemon.result(5)["pets"][0]["vx"] == 0.0);
    CHECK(daemon.result(5)["pets"][0]["x"] > 200.0);
    CHECK(daemon.result(7)["pets"][0]["x"] == 100.0);
    CHECK(daemon.result(8) == json{{"pets", 2}});
    CHECK(daemon.result(9)["total"] == 1);
    CHECK(daemon.result(10) == json{{"pets", 1}});
    CHECK(daemon.recorded.desktop.answers()[10].which == Answer::last);
}

TEST_CASE("what the engine refuses is told, and nothing has happened") {
    AskedDaemon daemon(3.0);
    daemon.at(1.0, R"({"do": "spawn", "count": 100})");
    daemon.at(1.0, R"({"do": "list"})");
    daemon.at(1.0, R"({"do": "spawn", "kind": "marmot"})");
    daemon.at(1.0, R"({"do": "spawn", "x": 5})");
    daemon.at(1.0, R"({"do": "stop", "pet": "7.7"})");
    daemon.at(1.0, R"({"do": "fling", "kind": "hyrax"})");
    daemon.at(1.0, "nonsense");
    daemon.run();
    CHECK(daemon.refusal(0).starts_with("refused: spawn: the population limit of 100 pets"));
    CHECK(daemon.result(1)["total"] == 1);
    CHECK(daemon.refusal(2) == "refused: spawn: there is no kind of pet named \"marmot\"");
    CHECK(daemon.refusal(3) == "bad_request: x and y are only allowed together");
    CHECK(daemon.refusal(4) == "no_such_pet: there is no pet \"7.7\"");
    CHECK(
        daemon.refusal(5) == "bad_request: vx or vy must tell how fast the chosen pets are to fly"
    );
    CHECK(daemon.refusal(6).starts_with("bad_json: request:1:1: "));
}

TEST_CASE("status tells what the daemon does, pause and resume hold and free it, quit ends it") {
    AskedDaemon daemon(100.0);
    daemon.at(0.5, R"({"do": "status"})");
    daemon.at(0.6, R"({"do": "pause"})");
    daemon.at(50.0, R"({"do": "status"})");
    daemon.at(50.0, R"({"do": "resume"})");
    daemon.at(80.0, R"({"do": "status"})");
    daemon.at(90.0, R"({"do": "quit"})");
    daemon.run();
    CHECK(daemon.result(0)["pets"] == 1);
    CHECK(daemon.result(0)["awake"] == 1);
    CHECK(daemon.result(0)["integrator"] == "event_driven");
    CHECK(daemon.result(0)["energy"] > 0.0);
    CHECK(daemon.result(0)["seconds"] == 0.5);
    CHECK(daemon.result(0)["frames"] >= 30);
    CHECK(daemon.result(1) == json{{"paused", true}});
    CHECK(daemon.result(2)["paused"] == true);
    CHECK(daemon.result(2)["seconds"] == 0.6);
    CHECK(daemon.result(4)["asleep"] == 1);
    CHECK(daemon.result(4)["contacts_per_second"] > 0.0);
    CHECK(daemon.result(4)["problem"] == "");
    CHECK(daemon.result(5) == json::object());
    CHECK(to_seconds(daemon.recorded.desktop.now()) == doctest::Approx(90.0));
}

TEST_CASE("pets are hidden, for a time or until they are shown, and gathered") {
    AskedDaemon daemon(300.0);
    daemon.at(1.0, R"({"do": "hide", "minutes": 1})");
    daemon.at(2.0, R"({"do": "status"})");
    daemon.at(70.0, R"({"do": "status"})");
    daemon.at(80.0, R"({"do": "hide"})");
    daemon.at(200.0, R"({"do": "status"})");
    daemon.at(201.0, R"({"do": "gather"})");
    daemon.at(202.0, R"({"do": "status"})");
    daemon.at(203.0, R"({"do": "hide", "minutes": -1})");
    daemon.run();
    CHECK(daemon.result(0) == json{{"hidden", true}});
    CHECK(daemon.result(1)["hidden"] == true);
    CHECK(daemon.result(2)["hidden"] == false);
    CHECK(daemon.result(4)["hidden"] == true);
    CHECK(daemon.result(5) == json::object());
    CHECK(daemon.result(6)["hidden"] == false);
    CHECK(daemon.refusal(7).starts_with("bad_request: minutes"));
}

TEST_CASE("a setting is read, written into the file, and holds at once") {
    AskedDaemon daemon(2.0);
    daemon.at(1.0, R"({"do": "config get", "key": "/physics/gravity"})");
    daemon.at(1.0, R"({"do": "config set", "key": "physics.gravity", "value": 0})");
    daemon.at(1.0, R"({"do": "config get", "key": "physics.gravity"})");
    daemon.at(1.0, R"({"do": "config set", "key": "physics.restitution", "value": 1.5})");
    daemon.at(1.0, R"({"do": "config set", "key": "scripts.run", "value": ["a.lua"]})");
    daemon.at(1.0, R"({"do": "config get"})");
    daemon.run();
    CHECK(daemon.result(0)["value"] == 1200.0);
    CHECK(daemon.result(0)["unit"] == "px/s^2");
    CHECK(daemon.result(1) == json{{"key", "physics.gravity"}, {"value", 0}});
    CHECK(daemon.result(2)["value"] == 0.0);
    CHECK(daemon.refusal(3).starts_with("bad_value: not written: "));
    CHECK(daemon.refusal(3).ends_with("/physics/restitution: must be a number from 0 to 1, got 1.5")
    );
    CHECK(daemon.result(4)["value"] == json{"a.lua"});
    CHECK(daemon.result(5)["settings"].size() > 15);
    CHECK(daemon.recorded.daemon->engine().settings().physics.gravity == 0.0);
    CHECK(
        daemon.recorded.folder.read("config.json") ==
        "{\n    \"scripts\": {\"run\": [\"a.lua\"]},\n"
        "    \"pets\": {\"start\": [{\"x\": 900, \"y\": 400}]},\n"
        "    // kept\n"
        "    \"physics\": {\"gravity\": 0}\n}"
    );
}

TEST_CASE("reload tells what is wrong, scripts are shown") {
    AskedDaemon daemon(2.0);
    daemon.recorded.script("a.lua", "local x = 1");
    daemon.at(0.5, R"({"do": "scripts"})");
    daemon.at(0.5, R"({"do": "reload"})");
    daemon.recorded.desktop.add({
        from_seconds(1.0),
        input::Asked{9, R"({"do": "reload"})"},
        [&daemon] { daemon.recorded.config("{"); },
    });
    daemon.recorded.desktop.add({
        from_seconds(1.2),
        input::Asked{9, R"({"do": "reload"})"},
        [&daemon] {
            daemon.recorded.config("{}");
            daemon.recorded.folder.write("sprites/cat/sprite.json", "{");
            daemon.recorded.script("b.lua", "local x = 2");
        },
    });
    daemon.at(1.2, R"({"do": "scripts"})");
    daemon.run();
    const json script = daemon.result(0)["scripts"][0];
    CHECK(script["name"] == "a.lua");
    CHECK(script["state"] == "on");
    CHECK(script["bytes"] == 11);
    CHECK(script["error"] == "");
    CHECK(daemon.result(1) == json::object());
    CHECK(daemon.refusal(2).starts_with("problem: "));
    CHECK(daemon.refusal(2).contains("config.json:1:2: "));
    CHECK(daemon.refusal(3).contains("cat/sprite.json:1:"));
    CHECK(daemon.result(4)["scripts"].size() == 2);
}

TEST_CASE("what scripts and plugins use is shown") {
    AskedDaemon asked(9.0);
    asked.recorded.script("a.lua", R"(
        hyrax.spawn{ x = 100, y = 0 }
        hyrax.on("land", function() end)
        hyrax.on("click", function() end)
        hyrax.every(1, function() error("oh") end)
    )");
    asked.recorded.script("b.lua", "local kept = ('x'):rep(100000) function f() return kept end");
    asked.recorded.folder.write(
        "plugins/rock/plugin.json",
        R"({"manifest": 1, "id": "rock", "version": "1.0.0", "api": "1.0", "name": "Rock"})"
    );
    asked.recorded.folder.write(
        "plugins/rock/main.lua", "hyrax.spawn() hyrax.spawn() for i = 1, 100000 do end"
    );
    asked.at(3.5, R"({"do": "scripts"})");
    asked.at(3.5, R"({"do": "plugins"})");
    asked.at(6.5, R"({"do": "scripts"})");
    asked.at(6.5, R"({"do": "scripts off", "script": "a.lua"})");
    asked.at(8.0, R"({"do": "scripts"})");
    asked.run();
    const json before = asked.result(0)["scripts"];
    CHECK(before[0]["pets"] == 1);
    CHECK(before[0]["errors"] == 3);
    CHECK(before[0]["hears"] == json{"land", "click"});
    CHECK(before[1]["errors"] == 0);
    CHECK(before[1]["memory"].get<int>() - before[0]["memory"].get<int>() > 90'000);
    const json plugins = asked.result(1)["plugins"];
    const auto rock =
        std::ranges::find_if(plugins, [](const json& one) { return one["id"] == "rock"; });
    REQUIRE(rock != plugins.end());
    CHECK((*rock)["pets"] == 2);
    CHECK((*rock)["units"] > 100'000);
    const json after = asked.result(2)["scripts"];
    CHECK(after[0]["errors"] == 6);
    CHECK(after[0]["units"] > before[0]["units"]);
    CHECK(after[1]["units"] == before[1]["units"]);
    const json off = asked.result(4)["scripts"];
    CHECK(off[0]["state"] == "off");
    CHECK(off[0]["units"] == 0);
    CHECK(off[0]["pets"] == 1);
}

TEST_CASE("plugins are listed, allowed and denied") {
    AskedDaemon asked(6.0);
    asked.recorded.folder.write(
        "plugins/rock/plugin.json",
        R"({"manifest": 1, "id": "rock", "version": "1.0.0", "api": "1.0", "name": "Rock",)"
        R"( "permissions": ["wind"]})"
    );
    asked.recorded.folder.write("plugins/rock/main.lua", "hyrax.wind(5)");
    asked.at(1.0, R"({"do": "plugins"})");
    asked.at(2.0, R"({"do": "plugins", "act": "allow", "plugin": "rock"})");
    asked.at(3.0, R"({"do": "plugins", "act": "deny", "plugin": "rock"})");
    asked.at(4.0, R"({"do": "plugins", "act": "deny", "plugin": "none"})");
    asked.at(5.0, R"({"do": "plugins", "act": "permit", "plugin": "rock"})");
    asked.run();
    const json list = asked.result(0)["plugins"];
    const auto rock =
        std::ranges::find_if(list, [](const json& one) { return one["id"] == "rock"; });
    REQUIRE(rock != list.end());
    CHECK((*rock)["state"] == "asks");
    CHECK((*rock)["missing"] == json{"wind"});
    CHECK(asked.result(1)["state"] == "on");
    CHECK(asked.result(2)["state"] == "off");
    CHECK(asked.refusal(3) == "no_such_plugin: there is no plugin \"none\"");
    CHECK(asked.refusal(4).contains("act: must be \"allow\" or \"deny\", got \"permit\""));
}

TEST_CASE("a plugin's settings are read and written as its manifest wants them") {
    AskedDaemon asked(4.0, R"({
    // kept
    "plugins": {"rock": {"name": "rocker", "jumps": 99}}
})");
    asked.recorded.folder.write(
        "plugins/rock/plugin.json",
        R"({"manifest": 1, "id": "rock", "version": "1.0.0", "api": "1.0", "name": "Rock",)"
        R"( "config": [{"key": "jumps", "type": "integer", "min": 1, "max": 20, "default": 5,)"
        R"( "label": "Jumps of a party"}, {"key": "name", "type": "string", "default": "a"}]})"
    );
    asked.recorded.folder.write(
        "plugins/rock/main.lua",
        "hyrax.on('config', function(k, v) hyrax.spawn{ tag = k .. v } end)"
    );
    asked.at(1.0, R"({"do": "config get", "key": "plugins.rock.jumps"})");
    asked.at(1.0, R"({"do": "config get", "key": "/plugins/rock/name"})");
    asked.at(1.0, R"({"do": "config set", "key": "plugins.rock.jumps", "value": 7.0})");
    asked.at(1.0, R"({"do": "config set", "key": "plugins.catch.enabled", "value": true})");
    asked.at(1.0, R"({"do": "config get", "key": "plugins.rock.jumps"})");
    asked.at(1.0, R"({"do": "config get"})");
    asked.at(2.0, R"({"do": "config set", "key": "plugins.rock.jumps", "value": 21})");
    asked.at(2.0, R"({"do": "config set", "key": "plugins.rock.name", "value": 5})");
    asked.at(2.0, R"({"do": "config set", "key": "plugins.rock.jmups", "value": 5})");
    asked.at(2.0, R"({"do": "config get", "key": "plugins.rokc.jumps"})");
    asked.at(2.0, R"({"do": "config get", "key": "plugins.rock"})");
    asked.at(3.0, R"({"do": "list", "tag": "jumps7"})");
    asked.run();
    // What does not fit does not hold.
    CHECK(
        asked.result(0) ==
        json::parse(R"({"key": "plugins.rock.jumps", "value": 5, "unit": "",)"
                    R"( "type": "integer", "low": 1.0, "high": 20.0, "default": 5,)"
                    R"( "description": "Jumps of a party"})")
    );
    CHECK(asked.result(1)["value"] == "rocker");
    CHECK(asked.result(2) == json{{"key", "plugins.rock.jumps"}, {"value", 7}});
    CHECK(asked.result(4)["value"] == 7);
    const json listed = asked.result(5)["settings"];
    const json jumps{{"key", "plugins.rock.jumps"}, {"value", 7}, {"unit", ""}};
    const json enabled{{"key", "plugins.catch.enabled"}, {"value", true}, {"unit", ""}};
    const json off{{"key", "plugins.clock.enabled"}, {"value", false}, {"unit", ""}};
    CHECK(std::ranges::count(listed, jumps) == 1);
    CHECK(std::ranges::count(listed, enabled) == 1);
    CHECK(std::ranges::count(listed, off) == 1);
    CHECK(
        asked.refusal(6) == "bad_value: not written: plugins.rock.jumps: must be a whole number "
                            "from 1 to 20, got 21"
    );
    CHECK(asked.refusal(7).ends_with("plugins.rock.name: must be a text in double quotes, got 5"));
    CHECK(
        asked.refusal(8) ==
        "bad_request: key: plugins.rock.jmups: there is no \"jmups\"; did you mean \"jumps\"?"
    );
    CHECK(asked.refusal(9).ends_with("there is no \"rokc\"; did you mean \"rock\"?"));
    CHECK(asked.refusal(10).ends_with("known: enabled, jumps, name"));
    CHECK(asked.result(11)["total"] == 1);  // The script has heard of it.
    CHECK(
        asked.recorded.folder.read("config.json") ==
        "{\n    // kept\n"
        "    \"plugins\": {\"catch\": {\"enabled\": true}, "
        "\"rock\": {\"name\": \"rocker\", \"jumps\": 7}}\n}"
    );
}

TEST_CASE("those who watch hear of what they want, until they leave") {
    AskedDaemon daemon(10.0);
    daemon.at(0.0, R"({"do": "events", "only": ["land", "spawn"]})");          // 1
    daemon.at(0.0, R"({"do": "events"})");                                     // 2
    daemon.at(0.0, R"({"do": "events"})");                                     // 3
    daemon.at(4.0, R"({"do": "spawn", "kind": "hyrax", "x": 100, "y": 50})");  // 4
    daemon.recorded.at(4.5, input::Left{2});
    daemon.recorded.at(6.0, input::Left{1});
    daemon.at(7.0, R"({"do": "spawn"})");   // 5
    daemon.at(7.0, R"({"do": "events"})");  // 6
    daemon.at(8.0, R"({"do": "remove"})");  // 7
    daemon.run();
    std::map<ClientId, std::vector<json>> heard;
    for (const RecordedAnswer& answer : daemon.recorded.desktop.answers()) {
        heard[answer.client].push_back(json::parse(answer.text));
    }
    CHECK(heard[1][0]["result"]["events"] == json{"spawn", "land"});
    CHECK(heard[3][0]["error"]["code"] == "busy");
    std::vector<std::string> names;
    for (std::size_t i = 1; i < heard[1].size(); ++i) {
        names.push_back(heard[1][i]["event"]);
    }
    CHECK(names == std::vector<std::string>{"land", "spawn", "land"});
    CHECK(heard[1][2]["kind"] == "hyrax");
    CHECK(heard[1][2]["pet"] == "1.1");
    CHECK(heard[1][3]["speed"] > 100.0);
    CHECK(heard[1][3]["seconds"].get<double>() > 4.0);
    // The second left before the second landing.
    CHECK(heard[2].back()["event"] != "land");
    CHECK(heard[2].size() > 4);
    CHECK(heard[6].back()["event"] == "remove");
}

TEST_CASE("an answer never breaks the bounds of a message") {
    AskedDaemon daemon(2.0, R"({"pets": {"start": [{"count": 1000}], "max": 10000}})");
    daemon.at(1.0, R"({"do": "list", "most": 200})");
    daemon.at(1.0, R"({"do": ")" + std::string(60'000, 'a') + "\"}");
    daemon.at(1.0, std::string(60'000, '{'));
    daemon.at(1.0, R"({"do": "spawn", "count": 1000})");
    daemon.run();
    CHECK(daemon.result(0)["pets"].size() == 200);
    for (const RecordedAnswer& answer : daemon.recorded.desktop.answers()) {
        CHECK(answer.text.size() >= min_message);
        CHECK(answer.text.size() <= max_message);
    }
}

TEST_CASE("without a controller nobody is answered") {
    RecordedDaemon recorded(1.0);
    recorded.at(0.5, input::Asked{1, R"({"do": "quit"})"});
    recorded.run();
    CHECK(recorded.desktop.answers().empty());
    CHECK(to_seconds(recorded.desktop.now()) == doctest::Approx(1.0));
}
