// SPDX-License-Identifier: MIT
// run, eval and the switches, in a whole daemon.
#include "tests/control/asked_daemon.h"

#include <doctest/doctest.h>

#include <string>

using namespace hyrax;
using nlohmann::json;

namespace {

constexpr std::string_view for_developers =
    R"({"pets": {"start": []}, "scripts": {"developer": true}})";

std::string run(std::string_view name, std::string_view text) {
    return json{{"do", "run"}, {"name", name}, {"text", text}}.dump();
}

std::string eval(std::string_view script, std::string_view code) {
    return json{{"do", "eval"}, {"script", script}, {"code", code}}.dump();
}

}  // namespace

TEST_CASE("code is run for developers alone") {
    AskedDaemon daemon(3.0, R"({"pets": {"start": []}})");
    daemon.recorded.script("a.lua", "count = 3");
    daemon.at(1.0, eval("a.lua", "count"));
    daemon.at(1.0, run("b.lua", "print 'no'"));
    daemon.at(1.0, R"({"do": "scripts"})");
    daemon.at(1.5, R"({"do": "config set", "key": "scripts.developer", "value": true})");
    daemon.at(2.0, eval("a.lua", "count"));
    daemon.run();
    CHECK(daemon.refusal(0).starts_with("refused: only for developers: set scripts.developer in"));
    CHECK(daemon.refusal(1).starts_with("refused: only for developers"));
    CHECK(daemon.result(2)["scripts"].size() == 1);
    CHECK(daemon.result(4) == json{{"script", "a.lua"}, {"printed", ""}, {"value", "3"}});
}

TEST_CASE("no script of a developer's runs once that is off") {
    AskedDaemon daemon(3.0, for_developers);
    daemon.at(0.5, run("b.lua", "hyrax.every(0.1, function() hyrax.spawn() end)"));
    daemon.recorded.change_file(1.0, "config.json", R"({"pets": {"start": []}})");
    daemon.at(1.5, R"({"do": "status"})");
    daemon.at(2.5, R"({"do": "status"})");
    daemon.run();
    CHECK(daemon.result(1)["pets"] > 0);
    CHECK(daemon.result(2)["pets"] == daemon.result(1)["pets"]);
}

TEST_CASE("a script is run, run again, asked and stopped") {
    AskedDaemon daemon(5.0, for_developers);
    const std::string text = "runs = (runs or 0) + 1 hyrax.spawn{tag = 'b'} hyrax.on('unload', "
                             "function(why) print('bye', why) end)";
    daemon.at(1.0, run("b.lua", text));
    daemon.at(1.5, R"({"do": "list", "tag": "b"})");
    daemon.at(2.0, run("b.lua", text));
    daemon.at(2.5, R"({"do": "list", "tag": "b"})");
    daemon.at(2.5, eval("b.lua", "runs, hyrax.pets()"));
    daemon.at(3.0, R"({"do": "scripts"})");
    daemon.at(3.0, R"({"do": "run", "name": "b.lua", "stop": true})");
    daemon.at(3.5, R"({"do": "run", "name": "b.lua", "stop": true})");
    daemon.at(3.5, eval("b.lua", "runs"));
    daemon.at(3.5, R"({"do": "scripts"})");
    daemon.run();
    CHECK(daemon.result(0) == json{{"script", "run:b.lua"}});
    CHECK(daemon.result(1)["total"] == 1);
    CHECK(daemon.result(1)["pets"][0]["owner"] == "run:b.lua");
    CHECK(daemon.result(3)["total"] == 2);
    CHECK(daemon.result(4)["value"].get<std::string>().starts_with("1, {pet"));
    CHECK(daemon.result(5)["scripts"][0]["name"] == "run:b.lua");
    CHECK(daemon.result(5)["scripts"][0]["state"] == "on");
    CHECK(daemon.result(6) == json::object());
    CHECK(daemon.refusal(7) == "no_such_script: nobody has run a script \"b.lua\"");
    CHECK(
        daemon.refusal(8) == "no_such_script: there is no script \"b.lua\"; there is none at all"
    );
    CHECK(daemon.result(9)["scripts"].empty());
}

TEST_CASE("the error of a main chunk is the answer") {
    AskedDaemon daemon(4.0, for_developers);
    daemon.at(0.5, run("b.lua", "\nerror('oh')"));
    daemon.at(1.0, run("b.lua", "\nerror('oh')"));
    daemon.at(1.5, run("b.lua", "while true do end"));
    daemon.at(2.0, R"({"do": "scripts"})");
    daemon.at(2.5, run("b.lua", "good = true"));
    daemon.at(3.0, run("b.lua", "not Lua"));
    daemon.at(3.5, eval("b.lua", "good"));
    daemon.run();
    CHECK(daemon.refusal(0) == "script_error: run:b.lua:2: oh");
    CHECK(daemon.refusal(1) == "script_error: run:b.lua:2: oh");
    CHECK(daemon.refusal(2).starts_with("script_error: run:b.lua:1: used more than"));
    CHECK(daemon.result(3)["scripts"][0]["state"] == "ended");
    CHECK(daemon.result(4) == json{{"script", "run:b.lua"}});
    CHECK(daemon.refusal(5).starts_with("script_error: run:b.lua:1: "));
    CHECK(daemon.result(6)["value"] == "true");  // What ran before goes on.
}

TEST_CASE("scripts come in parts, and parts that do not follow are refused") {
    AskedDaemon daemon(3.0, for_developers);
    const auto part = [](std::string_view name, std::string_view text, std::size_t at, bool more) {
        return json{{"do", "run"}, {"name", name}, {"text", text}, {"at", at}, {"more", more}}.dump(
        );
    };
    daemon.at(0.5, part("b.lua", "x =", 0, true));
    daemon.at(0.6, part("b.lua", " 5", 3, false));
    daemon.at(0.7, eval("b.lua", "x"));
    daemon.at(1.0, part("b.lua", "x =", 0, true));
    daemon.at(1.1, part("c.lua", " 6", 3, false));
    daemon.at(1.2, part("b.lua", " 6", 3, false));
    daemon.at(1.3, part("b.lua", " 6", 7, true));
    daemon.at(1.4, eval("b.lua", "x"));
    for (int i = 0; i < 23; ++i) {
        daemon.at(
            2.0, part("b.lua", std::string(50'000, ' '), 50'000U * static_cast<unsigned>(i), true)
        );
    }
    daemon.run();
    CHECK(daemon.result(0) == json{{"bytes", 3}});
    CHECK(daemon.result(2)["value"] == "5");
    for (const std::size_t wrong : {4U, 5U, 6U}) {
        CHECK(daemon.refusal(wrong).starts_with("bad_request: at: this part does not follow"));
    }
    CHECK(daemon.result(7)["value"] == "5");
    CHECK(daemon.result(27) == json{{"bytes", 1'000'000}});
    CHECK(daemon.refusal(28) == "refused: a script has at most 1048576 bytes");
    CHECK(daemon.refusal(30).starts_with("bad_request: at: "));
}

TEST_CASE("an answer that scripts owe has an end") {
    AskedDaemon daemon(12.0, for_developers);
    daemon.recorded.script("a.lua", "x = 1");
    daemon.at(0.5, eval("a.lua", "hyrax.wait(100)"));
    daemon.at(1.0, eval("a.lua", "x"));
    daemon.at(2.0, eval("a.lua", "hyrax.wait(2) return 'slow'"));
    daemon.at(6.0, R"({"do": "pause"})");
    daemon.at(7.0, eval("a.lua", "x"));
    daemon.at(7.0, run("b.lua", ""));
    daemon.at(8.0, R"({"do": "resume"})");
    daemon.at(9.0, eval("a.lua", "while true do end"));
    daemon.at(10.0, eval("a.lua", "x"));
    daemon.run();
    const auto& answers = daemon.recorded.desktop.answers();
    CHECK(answers[0].client == 2);  // Nobody waits for the first.
    CHECK(daemon.result(0)["value"] == "1");
    CHECK(answers[1].client == 3);
    CHECK(daemon.result(1)["value"] == "\"slow\"");
    CHECK(answers[2].client == 1);
    CHECK(daemon.refusal(2) == "script_error: no answer within 4 s; the script goes on");
    CHECK(
        daemon.refusal(4) == "refused: scripts stand still while hyrax is paused: hyraxctl resume"
    );
    CHECK(daemon.refusal(5).starts_with("refused: scripts stand still"));
    CHECK(daemon.refusal(7).starts_with("script_error: a.lua: eval:1: used more than"));
    CHECK(daemon.refusal(8) == "script_error: a.lua does not run");
}

TEST_CASE("scripts are switched off and on, and started anew") {
    AskedDaemon daemon(5.0, R"({"pets": {"start": []}})");
    daemon.recorded.script("a.lua", "hyrax.spawn()");
    daemon.recorded.script("bad.lua", "error('no')");
    daemon.at(0.5, R"({"do": "scripts off", "script": "a.lua"})");
    daemon.at(0.6, R"({"do": "scripts"})");
    daemon.at(1.0, R"({"do": "scripts on", "script": "a.lua"})");
    daemon.at(1.5, R"({"do": "scripts reload", "script": "a.lua"})");
    daemon.at(2.0, R"({"do": "status"})");
    daemon.at(2.0, R"({"do": "scripts reload", "script": "bad.lua"})");
    daemon.at(2.5, R"({"do": "scripts off", "script": "c.lua"})");
    daemon.at(3.0, R"({"do": "scripts"})");
    daemon.run();
    CHECK(daemon.result(0) == json{{"script", "a.lua"}, {"on", false}});
    CHECK(daemon.result(1)["scripts"][0]["state"] == "off");
    CHECK(daemon.result(2) == json{{"script", "a.lua"}, {"on", true}});
    CHECK(daemon.result(3) == json{{"script", "a.lua"}});
    CHECK(daemon.result(4)["pets"] == 3);
    CHECK(daemon.refusal(5) == "script_error: bad.lua:1: no");
    CHECK(
        daemon.refusal(6) == "no_such_script: there is no script \"c.lua\"; known: a.lua, bad.lua"
    );
    const json scripts = daemon.result(7)["scripts"];
    CHECK(scripts[1]["state"] == "ended");
    CHECK(scripts[1]["error"] == "bad.lua:1: no");
}
