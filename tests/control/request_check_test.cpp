// SPDX-License-Identifier: MIT
#include "daemon/control/request_check.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>

using namespace hyrax;
using nlohmann::json;

namespace {

std::string refusal(std::string_view text) {
    const auto request = check_request(text);
    return request ? "none" : request.error().code + ": " + request.error().message;
}

// A value that a parameter takes.
json example_of(const Parameter& parameter) {
    switch (parameter.type) {
        case ParameterType::number:
        case ParameterType::whole_number:
            return parameter.range.high;
        case ParameterType::text:
            return "hyrax";
        case ParameterType::pet:
            return "3.1";
        case ParameterType::key:
            return "physics.gravity";
        case ParameterType::json:
            return json{1, nullptr, {{"a", true}}};
        case ParameterType::events:
            return {"land", "bounce"};
        case ParameterType::script:
            return "fountain.lua";
        case ParameterType::code:
            return "\tprint('hello')\n";
        case ParameterType::flag:
            return true;
    }
    return {};
}

}  // namespace

TEST_CASE("the table of verbs is fit to be read") {
    std::set<std::string_view> names;
    for (const Verb& verb : verbs()) {
        INFO(verb.name);
        CHECK(names.insert(verb.name).second);
        CHECK(verb.help.ends_with('.'));
        CHECK(verb.example.starts_with(verb.name));
        CHECK((verb.carry_out != nullptr));
        std::set<std::string_view> parameters;
        for (const Parameter& parameter : verb.parameters) {
            INFO(parameter.name);
            CHECK(parameters.insert(parameter.name).second);
            CHECK(parameter.name != "do");
            CHECK(parameter.help.ends_with('.'));
            CHECK(parameter.range.low <= parameter.range.high);
        }
    }
}

TEST_CASE("every verb takes all its arguments, and refuses wrong ones by name") {
    for (const Verb& verb : verbs()) {
        INFO(verb.name);
        json request{{"do", verb.name}};
        for (const Parameter& parameter : verb.parameters) {
            request[std::string(parameter.name)] = example_of(parameter);
        }
        CHECK(refusal(request.dump()) == "none");
        for (const Parameter& parameter : verb.parameters) {
            const std::string name(parameter.name);
            json wrong = request;
            if (parameter.type != ParameterType::json) {
                wrong[name] = parameter.type == ParameterType::flag ? json(1) : json(true);
                CHECK(
                    refusal(wrong.dump()) == "bad_request: " + name + ": must be " +
                                                 expectation(parameter) + ", got " +
                                                 wrong[name].dump()
                );
            }
            if (parameter.type == ParameterType::number ||
                parameter.type == ParameterType::whole_number) {
                wrong[name] = parameter.range.high + 1;
                CHECK(refusal(wrong.dump()).starts_with("bad_request: " + name + ": must be "));
                wrong[name] = parameter.range.low - 1;
                CHECK(refusal(wrong.dump()).starts_with("bad_request: " + name + ": must be "));
            }
            wrong.erase(name);
            CHECK((refusal(wrong.dump()) == "none") == !parameter.required);
        }
        request["nonsense"] = 1;
        CHECK(refusal(request.dump()).starts_with("bad_request: "));
    }
}

TEST_CASE("refusals say what was expected and what was found") {
    CHECK(refusal("{").starts_with("bad_json: request:1:2: "));
    CHECK(refusal("").starts_with("bad_json: "));
    CHECK(refusal("\xFF\xFE").starts_with("bad_json: request:1:1: byte 0xFF is not UTF-8"));
    CHECK(refusal(R"({"do": "status", "do": "quit"})")
              .starts_with("bad_json: request:1:18: the key \"do\""));
    CHECK(refusal("[1]") == R"(bad_request: a request must be an object such as {"do": "status"})");
    CHECK(
        refusal(R"({"do": 5})") ==
        R"(bad_request: do: must be the name of a verb, as in {"do": "status"})"
    );
    CHECK(
        refusal(R"({"do": "spwan"})") ==
        R"(unknown_verb: do: there is no "spwan"; did you mean "spawn"?)"
    );
    CHECK(
        refusal(R"({"do": "spawn", "cuont": 1})") ==
        R"(bad_request: spawn: there is no "cuont"; did you mean "count"?)"
    );
    CHECK(
        refusal(R"({"do": "quit", "now": 1})") ==
        R"(bad_request: quit takes no arguments, got "now")"
    );
    CHECK(
        refusal(R"({"do": "spawn", "count": 1.5})") ==
        "bad_request: count: must be a whole number from 1 to 1000, got 1.5"
    );
    CHECK(refusal(R"({"do": "spawn", "tag": "a\u0007"})")
              .starts_with("bad_request: tag: must be a text of 1 to 64 bytes"));
    CHECK(
        refusal(R"({"do": "remove", "pet": "3"})") ==
        R"(bad_request: pet: must be a pet's id such as "3.1", as list shows it, got "3")"
    );
    CHECK(
        refusal(R"({"do": "config get", "key": "physics.gravty"})") ==
        R"(bad_request: key: there is no "physics.gravty"; did you mean "physics.gravity"?)"
    );
    CHECK(
        refusal(R"({"do": "events", "only": ["bounce", "lnad"]})") ==
        R"(bad_request: only: there is no "lnad"; did you mean "land"?)"
    );
}

TEST_CASE("deep requests are refused") {
    const auto nested = [](std::size_t depth) {
        return R"({"do": "config set", "key": "scripts.run", "value": )" + std::string(depth, '[') +
               std::string(depth, ']') + "}";
    };
    CHECK(refusal(nested(max_request_depth - 1)) == "none");
    CHECK(refusal(nested(max_request_depth)) == "bad_json: request: nested more than 16 deep");
    CHECK(refusal(nested(30'000)).starts_with("bad_json: request:1:"));
}

TEST_CASE("no text breaks the check") {
    std::minstd_rand random(7);
    const std::vector<std::string> seeds{
        R"({"do": "spawn", "kind": "hyrax", "count": 3, "x": -1e3, "y": 2.5, "tag": "\u00e4"})",
        R"({"do": "config set", "key": "/pets/start", "value": [{"kind": "hyrax"}]})",
        R"({"do": "events", "only": ["bounce", "land"]})",
    };
    for (int i = 0; i < 20'000; ++i) {
        std::string text = seeds[random() % seeds.size()];
        for (std::size_t edits = random() % 6; edits > 0 && !text.empty(); --edits) {
            const std::size_t at = random() % text.size();
            switch (random() % 3) {
                case 0:
                    text[at] = static_cast<char>(random() % 256);
                    break;
                case 1:
                    text.erase(at, random() % 9);
                    break;
                default:
                    text.insert(at, text.substr(random() % text.size(), random() % 9));
            }
        }
        const auto request = check_request(text);
        CHECK((request ? request->verb != nullptr : !request.error().message.empty()));
    }
}

TEST_CASE("a pet's id goes into text and back") {
    CHECK(pet_text({3, 1}) == "3.1");
    CHECK(pet_from_text("3.1") == PetId{3, 1});
    for (const char* wrong :
         {"", "3", "3.", ".1", "3.1 ", " 3.1", "-3.1", "3.1.1", "4294967296.1", "a.b"}) {
        INFO(wrong);
        CHECK_FALSE(pet_from_text(wrong).has_value());
    }
}
