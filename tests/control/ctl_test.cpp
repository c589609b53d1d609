// SPDX-License-Identifier: MIT
#include "daemon/control/ctl_command_line.h"
#include "daemon/control/ctl_output.h"
#include "daemon/control/request_check.h"
#include "daemon/control/verb.h"
#include "daemon/core/files.h"
#include "daemon/core/framing.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <sstream>
#include <string>

using namespace hyrax;
using nlohmann::json;

namespace {

std::vector<std::string> words_of(std::string_view line) {
    std::istringstream stream{std::string(line)};
    std::vector<std::string> words;
    for (std::string word; stream >> word;) {
        words.push_back(word);
    }
    return words;
}

CtlTask task_of(std::string_view line) {
    const auto parsed = parse_ctl_arguments(words_of(line));
    if (const auto* farewell = std::get_if<Farewell>(&parsed)) {
        FAIL(farewell->text);
    }
    const auto& read = std::get<CtlCommandLine>(parsed);
    CHECK(read.request.empty());
    REQUIRE(read.task.has_value());
    return *read.task;
}

json request_of(std::string_view line) {
    const auto parsed = parse_ctl_arguments(words_of(line));
    if (const auto* farewell = std::get_if<Farewell>(&parsed)) {
        FAIL(farewell->text);
    }
    return json::parse(std::get<CtlCommandLine>(parsed).request);
}

std::string complaint(std::string_view line) {
    const auto parsed = parse_ctl_arguments(words_of(line));
    const auto* farewell = std::get_if<Farewell>(&parsed);
    REQUIRE(farewell != nullptr);
    CHECK(farewell->exit_code == exit_usage);
    return farewell->text;
}

}  // namespace

TEST_CASE("command lines become requests") {
    CHECK(request_of("status") == json{{"do", "status"}});
    CHECK(
        request_of("spawn hyrax --count 3 --x -10.5 --y 20 --vy -600 --tag party") ==
        json{
            {"do", "spawn"},
            {"kind", "hyrax"},
            {"count", 3},
            {"x", -10.5},
            {"y", 20},
            {"vy", -600},
            {"tag", "party"},
        }
    );
    CHECK(
        request_of("--json fling 3.1 --vx 5") == json{{"do", "fling"}, {"pet", "3.1"}, {"vx", 5}}
    );
    CHECK(
        request_of("config set physics.integrator rk45 --profile x") ==
        json{{"do", "config set"}, {"key", "physics.integrator"}, {"value", "rk45"}}
    );
    CHECK(request_of("config set scripts.run [\"a\"]")["value"] == json{"a"});
    CHECK(request_of("events") == json{{"do", "events"}});
    CHECK(request_of("events land bounce")["only"] == json{"land", "bounce"});
}

TEST_CASE("each verb's example is a command line that fits it") {
    for (const Verb& verb : verbs()) {
        if (!verb.usage.empty()) {
            continue;
        }
        const json request = request_of(verb.example);
        CHECK(request["do"] == verb.name);
        CHECK(check_request(request.dump()).has_value());
    }
}

TEST_CASE("command lines of people who write scripts") {
    CHECK(
        request_of("eval a.lua count+1") ==
        json{{"do", "eval"}, {"script", "a.lua"}, {"code", "count+1"}}
    );
    CHECK(request_of("eval a.lua -- -5")["code"] == "-5");
    CHECK(request_of("scripts") == json{{"do", "scripts"}});
    CHECK(request_of("scripts off a.lua") == json{{"do", "scripts off"}, {"script", "a.lua"}});
    CHECK(request_of("run --stop a.lua") == json{{"do", "run"}, {"name", "a.lua"}, {"stop", true}});
    CHECK(std::get<task::RunFile>(task_of("run folder/a.lua")).file == "folder/a.lua");
    CHECK(std::get<task::Repl>(task_of("repl")).script.empty());
    CHECK(std::get<task::Repl>(task_of("repl a.lua --profile x")).script == "a.lua");
    CHECK(complaint("run").contains("a file is needed"));
    CHECK(complaint("run a.lua --stop a.lua").contains("--stop"));
    CHECK(complaint("eval a.lua").contains("code"));
    CHECK(complaint("scripts of a.lua").contains("of"));
    CHECK(complaint("eval a.lua " + std::string(70'000, 'x')).contains("65536 is the most"));
}

TEST_CASE("a script comes to the daemon in parts that are whole messages") {
    std::string text = "-- ä\n";
    for (int i = 0; i < 5'000; ++i) {
        text += "äöü\x01\"";
    }
    const auto requests = run_requests("a.lua", text);
    REQUIRE(requests.has_value());
    CHECK(requests->size() > 3);
    std::string joined;
    for (const std::string& request : *requests) {
        CHECK(request.size() <= max_message);
        CHECK(check_request(request).has_value());
        const json part = json::parse(request);
        CHECK(part["at"] == joined.size());
        joined += part["text"].get<std::string>();
        CHECK(part["more"] == (joined.size() < text.size()));
    }
    CHECK(joined == text);
    CHECK(run_requests("a.lua", "")->size() == 1);
    CHECK_FALSE(run_requests("a.lua", "\xFF").has_value());
    CHECK_FALSE(run_requests("a.lua", std::string(20'000, '\xA4')).has_value());
}

TEST_CASE("what a script answers is shown as it is") {
    const ShownAnswer shown = shown_answer(
        R"({"ok": true, "result": {"script": "a.lua", "printed": "x 1\n", "value": "\"b\", 2"}})"
    );
    CHECK(shown.text == "x 1\n\"b\", 2\n");
    CHECK(shown_answer(R"({"ok": true, "result": {"printed": "", "value": ""}})").text.empty());
    CHECK(is_unfinished("eval:2: 'end' expected (to close 'do' at line 1) near <eof>"));
    CHECK_FALSE(is_unfinished("eval:1: near <eof> there is nothing"));
}

TEST_CASE("wrong command lines are explained") {
    CHECK(complaint("spwan") == "hyraxctl: there is no \"spwan\"; did you mean \"spawn\"?\n");
    CHECK(
        complaint("spawn --count 0") ==
        "hyraxctl: spawn: count: must be a whole number from 1 to 1000, got 0\n"
    );
    CHECK(complaint("fling 3 --vx 1").contains("pet: must be a pet's id such as \"3.1\""));
    CHECK(complaint("config get physics.gravty").contains("did you mean \"physics.gravity\"?"));
    CHECK(complaint("events lnad").contains("did you mean \"land\"?"));
}

TEST_CASE("answers are tables and lines for people") {
    const ShownAnswer list = shown_answer(R"({"ok": true, "result": {"total": 12, "pets": [
        {"id": "0.1", "x": 3.5, "tag": "ä"}, {"id": "10.1", "x": -300, "tag": ""}]}})");
    CHECK(list.refusal.empty());
    CHECK(list.text == "id       x  tag\n0.1    3.5  ä\n10.1  -300\ntotal  12\n");
    CHECK(
        shown_answer(R"({"ok": true, "result": {"paused": true, "long_name": "a", "problem": ""}})")
            .text == "paused     yes\nlong_name  a\n"
    );
    CHECK(
        shown_answer(R"({"ok": true, "result": {"pets": ["1.1", "2.1"]}})").text ==
        "pets  1.1 2.1\n"
    );
    CHECK(shown_answer(R"({"ok": true, "result": {}})").text.empty());
    const ShownAnswer refused =
        shown_answer(R"({"ok": false, "error": {"code": "busy", "message": "no"}})");
    CHECK(refused.refusal == "busy");
    CHECK(refused.text == "no");
    for (const char* odd :
         {"",
          "5",
          "[]",
          "{}",
          R"({"ok": true})",
          R"({"ok": 1, "result": {}})",
          R"({"ok": false, "error": 3})"}) {
        CHECK_FALSE(shown_answer(odd).refusal.empty());
    }
    CHECK(
        shown_event(R"({"event": "land", "seconds": 1.5, "pet": "3.1", "speed": 20})") ==
        "     1.500  land      pet=3.1  speed=20\n"
    );
}

TEST_CASE("docs/control.md is made from the table of verbs") {
    const std::filesystem::path file =
        std::filesystem::path(HYRAX_SOURCE_DIR) / "docs" / "control.md";
    const Result<std::string> written = read_text_file(file, 1U << 20U);
    REQUIRE(written.has_value());
    // If this fails: hyraxctl manual > docs/control.md
    CHECK(*written == control_manual());
}

TEST_CASE("completion knows every verb and every setting") {
    for (const char* shell : {"bash", "powershell"}) {
        const std::string script = completion_script(shell);
        for (const Verb& verb : verbs()) {
            CHECK(script.contains(verb.name));
        }
        CHECK(script.contains("physics.gravity"));
    }
    CHECK(completion_script("fish").empty());
}
