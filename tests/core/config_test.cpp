// SPDX-License-Identifier: MIT
#include "daemon/core/config.h"

#include "daemon/core/files.h"
#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <string>

using namespace hyrax;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;
const fs::path shipped_folder = fs::path(HYRAX_SOURCE_DIR) / "config";

Config config_of(const std::string& text) {
    const Result<LoadedConfig> loaded = parse_config(text, "config.json");
    if (!loaded) {
        FAIL(text << "\n" << loaded.error().message);
    }
    CHECK(loaded->warnings.empty());
    return loaded->config;
}

std::string errors_of(const std::string& text) {
    const Result<LoadedConfig> loaded = parse_config(text, "config.json");
    return loaded ? "no error" : loaded.error().message;
}

std::vector<std::string> warnings_of(const std::string& text) {
    const Result<LoadedConfig> loaded = parse_config(text, "config.json");
    if (!loaded) {
        FAIL(loaded.error().message);
    }
    return loaded->warnings;
}

// A config in which nothing but one field has a value, and where that value stands in it.
struct OneField {
    std::string text;
    std::string place;  // "config.json:1:25: /pets/start/0/kind: "
};

OneField one_field(const std::string& path, const std::string& value) {
    std::string before;
    std::string after;
    std::string pointer;
    for (std::size_t at = 1; at <= path.size();) {
        const std::size_t end = std::min(path.find('/', at), path.size());
        const std::string step = path.substr(at, end - at);
        before += step == "*" ? "[" : "{\"" + step + "\": ";
        after = (step == "*" ? "]" : "}") + after;
        pointer += "/" + (step == "*" ? "0" : step);
        at = end + 1;
    }
    // x and y are only allowed together.
    if (path.ends_with("/x") || path.ends_with("/y")) {
        after = (path.ends_with("/x") ? ", \"y\": 0" : ", \"x\": 0") + after;
    }
    const std::string column = std::to_string(before.size() + 1);
    if (path.ends_with("/do")) {
        after = ", \"exe\": \"a\"" + after;
    }
    return {before + value + after, "config.json:1:" + column + ": " + pointer + ": "};
}

void check_refused(const ConfigField& field, const std::string& value, const std::string& found) {
    const OneField one = one_field(field.path, value);
    const std::string message = errors_of(one.text);
    CHECK_MESSAGE(message.starts_with(one.place + "must be "), message);
    CHECK_MESSAGE(message.contains(", got " + found), message);
    CHECK_FALSE_MESSAGE(message.contains('\n'), message);
}

void check_accepted(const ConfigField& field, const std::string& value) {
    CHECK(errors_of(one_field(field.path, value).text) == "no error");
}

bool is_numeric(const ConfigField& field) {
    return field.type == "number" || field.type == "integer";
}

const ConfigField& field_at(const std::vector<ConfigField>& fields, std::string_view path) {
    const auto found = std::ranges::find(fields, path, &ConfigField::path);
    REQUIRE(found != fields.end());
    return *found;
}

}  // namespace

TEST_CASE("config: an empty object means the defaults") {
    CHECK(config_of("{}") == Config{});
    CHECK(config_of("{\"physics\": {}, \"pets\": {}, \"overlay\": {}}") == Config{});
}

TEST_CASE("config: every key arrives where it belongs") {
    const Config config = config_of(R"({
        "$schema": "anything",
        "physics": {"gravity": 0.5, "restitution": 0.25, "air_drag": 0.5, "ground_friction": 0.75,
                    "rest_threshold": 7},
        "pets": {"start": [{"kind": "cat", "count": 2, "x": 1.5, "y": -2, "vx": 3, "vy": 4}, {}],
                 "max": 9, "max_spawn_rate": 2.5, "max_speed": 10, "max_throw_speed": 11, "drowsy_after": 12},
        "overlay": {"fps": 30.5, "floor": "screen", "ledges": "active",
                    "allowed_monitors": [2, "primary"], "allowed_area": [-10, 20, 300, 400],
                    "quiet": true, "click_through": true},
        "hotkeys": {"gather": "Ctrl + Alt + G", "hide": "", "click_through": "f9"},
        "scripts": {"run": ["a.lua", "examples/b*.lua"],
                    "limits": {"load_units": 123456, "memory": 100000, "max_speed": 1.5}},
        "log": {"level": "warn"}
    })");
    Config expected;
    expected.engine.physics = {
        .gravity = 0.5,
        .restitution = 0.25,
        .air_drag = 0.5,
        .ground_friction = 0.75,
        .rest_threshold = 7
    };
    expected.engine.max_pets = 9;
    expected.engine.max_spawn_rate = 2.5;
    expected.engine.max_speed = 10;
    expected.limits.load_units = 123'456;
    expected.limits.memory = 100'000;
    expected.limits.max_speed = 1.5;
    expected.start_pets.insert(expected.start_pets.begin(), {"cat", 2, Vec2{1.5, -2}, {3, 4}});
    expected.max_throw_speed = 11;
    expected.drowsy_after = 12;
    expected.fps = 30.5;
    expected.floor = FloorEdge::screen;
    expected.ledges = LedgeMode::active;
    expected.allowed.monitors = {MonitorName{"2"}, MonitorName{"primary"}};
    expected.allowed.area = Rect{-10, 20, 300, 400};
    expected.quiet = true;
    expected.click_through = true;
    expected.hotkeys[0] = KeyCombination{.ctrl = true, .alt = true, .key = Key{'g'}};
    expected.hotkeys[4] = KeyCombination{.key = Key{static_cast<int>(Key::f1) + 8}};
    expected.scripts = {"a.lua", "examples/b*.lua"};
    expected.log_level = "warn";
    CHECK(config == expected);
}

TEST_CASE("config: comments are allowed, lists may be empty, whole numbers may be written as 1e2") {
    const Config config =
        config_of("// a\n{ /* b */ \"pets\": { // c\n \"start\": [], \"max\": 1e2 } } /* d */\n");
    CHECK(config.start_pets.empty());
    CHECK(config.engine.max_pets == 100);
}

TEST_CASE("config: a wrong type, in every field, names place, key, expected and found") {
    for (const ConfigField& field : config_fields()) {
        if (field.path == "/$schema") {
            continue;
        }
        const std::map<std::string, std::string> values{
            {"true", "true"},
            {"null", "null"},
            {"{\"a\": 1}", "an object { }"},
            {"[[]]", "a list [ ]"},
            {"\"o/\\\\\"", "\"o/\\\\\""},
            {"-1e300", "-1e300"}
        };
        for (const auto& [value, found] : values) {
            const bool fits = (field.type == "array" && value == "[[]]") ||
                              (field.type == "object" && value.starts_with('{')) ||
                              (field.type == "boolean" && value == "true");
            if (!fits) {
                check_refused(field, value, found);
            }
        }
    }
}

TEST_CASE("config: every number is accepted at its bounds and refused beyond them") {
    int numbers = 0;
    for (const ConfigField& field : config_fields()) {
        if (!is_numeric(field)) {
            continue;
        }
        ++numbers;
        REQUIRE(field.low < field.high);
        const double step = field.type == "integer" ? 1.0 : 1e-6 * std::max(1.0, field.high);
        check_accepted(field, json(field.low).dump());
        check_accepted(field, json(field.high).dump());
        check_refused(field, json(field.low - step).dump(), json(field.low - step).dump());
        check_refused(field, json(field.high + step).dump(), json(field.high + step).dump());
        if (field.type == "integer") {
            check_refused(field, "1.5", "1.5");
        }
    }
    CHECK(numbers == 39);
}

TEST_CASE("config: names, choices and lists") {
    const std::vector<ConfigField> fields = config_fields();
    for (const ConfigField& field : fields) {
        for (const std::string& choice : field.choices) {
            check_accepted(field, json(choice).dump());
        }
        if (field.type == "array") {
            std::string list = "[";
            for (int i = 0; i <= static_cast<int>(field.high); ++i) {
                list += i == 0 ? "0" : ",0";
            }
            check_refused(field, list + "]", std::to_string(static_cast<int>(field.high) + 1));
        }
    }
    const ConfigField& kind = field_at(fields, "/pets/start/*/kind");
    check_accepted(kind, "\"Rock Hyrax \xE5\xB2\xA9\"");
    for (const char* bad : {"\"\"", "\"..\"", "\"a/b\"", "\"a\\\\b\"", "\"c:\"", "\"a\\u0000\""}) {
        check_refused(kind, bad, bad);
    }
    const std::string run = "/scripts/run/*";
    CHECK(errors_of(one_field(run, "\"a/*/b?.lua\"").text) == "no error");
    for (const char* bad : {"\"../a.lua\"", "\"/a.lua\"", "\"a//b\"", "\"C:/a.lua\"", "5"}) {
        const OneField one = one_field(run, bad);
        CHECK(errors_of(one.text).starts_with(one.place + "must be a file name"));
    }
}

TEST_CASE("config: messages as people see them") {
    CHECK(
        errors_of("{\n  \"physics\": {\n    \"restitution\": 1.5\n  }\n}") ==
        "config.json:3:20: /physics/restitution: must be a number from 0 to 1, got 1.5"
    );
    CHECK(
        errors_of("{\"physics\": {\"gravity\": \"high\"}}") ==
        "config.json:1:25: /physics/gravity: must be a number from 0 to 1000000000, "
        "got \"high\""
    );
    CHECK(
        errors_of("{\"overlay\": {\"floor\": \"sceen\"}}") ==
        "config.json:1:23: /overlay/floor: must be \"work_area\" or \"screen\", got \"sceen\"; "
        "did you mean \"screen\"?"
    );
    CHECK(
        errors_of("{\"physics\": 5}") == "config.json:1:13: /physics: must be an object { }, got 5"
    );
    CHECK(errors_of("[]") == "config.json:1:1: must be an object { }, got a list [ ]");
    CHECK(
        errors_of("{\"pets\": {\"start\": [{}, {\"x\": 5}]}}") ==
        "config.json:1:26: /pets/start/1/x: x and y are only allowed together"
    );
}

TEST_CASE("config: all errors of a file in one message") {
    CHECK(
        errors_of("{\"physics\": {\"air_drag\": 2},\n \"overlay\": {\"fps\": 0, \"flor\": 1},\n"
                  " \"log\": 7}") ==
        "config.json:1:26: /physics/air_drag: must be a number from 0 to 1, got 2\n"
        "config.json:2:21: /overlay/fps: must be a number from 1 to 1000, got 0\n"
        "config.json:3:9: /log: must be an object { }, got 7"
    );

    std::string many = "{\"pets\": {\"start\": [0";
    for (int i = 1; i < 30; ++i) {
        many += ",0";
    }
    const std::string message = errors_of(many + "]}}");
    CHECK(std::ranges::count(message, '\n') == 20);
    CHECK(message.ends_with("\n... and 10 more"));
}

TEST_CASE("config: unknown keys are warnings that name the nearest known key of that place") {
    CHECK(
        warnings_of("{\n  \"physics\": {\n    \"gravitty\": 1200\n  }\n}") ==
        std::vector<std::string>{
            "config.json:3:5: /physics/gravitty: unknown key; did you mean \"gravity\"?"
        }
    );
    CHECK(
        warnings_of("{\"Pets\": 5, \"zebra\": [], \"pets\": {\"start\": [{\"knid\": 1}]}}") ==
        std::vector<std::string>{
            "config.json:1:2: /Pets: unknown key; did you mean \"pets\"?",
            "config.json:1:13: /zebra: unknown key",
            "config.json:1:46: /pets/start/0/knid: unknown key; did you mean \"kind\"?",
        }
    );
    // Neither a path in one key nor a key of another place is a known key.
    CHECK(
        warnings_of("{\"physics/gravity\": 5}").at(0) ==
        "config.json:1:2: /physics~1gravity: unknown key"
    );
    CHECK(warnings_of("{\"gravity\": 5, \"\": 6}").size() == 2);
    CHECK(warnings_of("{\"a\\nb\": 1}").at(0) == "config.json:1:2: /a?b: unknown key");
}

TEST_CASE("config: files that are no config") {
    const TemporaryFolder folder;
    const auto complaint = [](const fs::path& path) {
        const Result<LoadedConfig> loaded = load_config(path);
        return loaded ? "loaded it" : loaded.error().message;
    };
    const fs::path file = folder.path() / "config.json";
    folder.write("config.json", "");
    const std::string name = utf8_from_path(file);
    CHECK(complaint(file) == name + ": the file is empty; at least {} is needed");
    CHECK(complaint(folder.path()).ends_with(": is a folder, not a file"));
    CHECK(complaint(folder.path() / "none.json").ends_with(": there is no such file"));
    folder.write("config.json", "{\"caf\xE9\": 1}");
    CHECK(complaint(file) == name + ":1:6: byte 0xE9 is not UTF-8; save the file as UTF-8");
    folder.write("config.json", std::string(10'000, '[') + std::string(10'000, ']'));
    CHECK(complaint(file) == name + ":1:65: nested more than 64 deep");
    folder.write("config.json", "\xEF\xBB\xBF{\"overlay\": {\"fps\": 0}}");
    CHECK(complaint(file).starts_with(name + ":1:21: /overlay/fps: must be"));

    fs::resize_file(file, 100U << 20U);
    CHECK(complaint(file) == name + ": is too large: 104857600 bytes, at most 1048576 are read");
}

TEST_CASE("config: the largest file is read to its end, whatever is in it") {
    // Below a second each; what is quadratic takes minutes and ends in the test run's time limit.
    std::string keys = "{\"\":0";
    for (int i = 0; keys.size() < (1U << 20U); ++i) {
        keys += ",\"" + std::to_string(i) + "\":0";
    }
    CHECK(errors_of(keys + "}") == "no error");
    std::string items = "{\"pets\":{\"start\":[0";
    while (items.size() < (1U << 20U)) {
        items += ",0";
    }
    CHECK(errors_of(items + "]}}").contains("/pets/start: "));
    CHECK(errors_of("{\"" + std::string(1U << 20U, 'g') + "\":0}") == "no error");
}

TEST_CASE("config: the shipped file states the defaults, with three pets to begin with") {
    const Result<LoadedConfig> shipped = load_config(shipped_folder / "config.json");
    if (!shipped) {
        FAIL(shipped.error().message);
    }
    CHECK(shipped->warnings.empty());
    Config expected;
    expected.start_pets = {{.kind = "hyrax", .count = 3}};
    CHECK(shipped->config == expected);
}

TEST_CASE("config: the shipped file shows every key but those of its example") {
    const Result<std::string> text = read_text_file(shipped_folder / "config.json", 1U << 20U);
    REQUIRE(text);
    const json config = json::parse(*text, nullptr, true, true);
    for (const ConfigField& field : config_fields()) {
        if (!field.path.contains("/*/")) {
            CHECK_MESSAGE(config.contains(json::json_pointer(field.path)), field.path);
        }
        const std::string key = field.path.substr(field.path.rfind('/') + 1);
        CHECK_MESSAGE(text->contains("\"" + key + "\""), key);
    }
}

namespace {

// Every key that a schema describes, by the path that config_fields() gives it.
void collect(const json& schema, const std::string& path, std::map<std::string, json>& found) {
    if (schema.contains("properties")) {
        for (const auto& [key, value] : schema["properties"].items()) {
            collect(value, path + "/" + key, found);
        }
        return;
    }
    found[path] = schema;
    if (schema.contains("items") && schema["items"].contains("properties")) {
        collect(schema["items"], path + "/*", found);
    }
}

}  // namespace

TEST_CASE("config: schema.json and the program know the same keys, ranges, defaults and texts") {
    const Result<std::string> text = read_text_file(shipped_folder / "schema.json", 1U << 20U);
    REQUIRE(text);
    std::map<std::string, json> schema;
    collect(json::parse(*text), "", schema);
    for (const ConfigField& field : config_fields()) {
        CAPTURE(field.path);
        REQUIRE(schema.contains(field.path));
        const json described = schema[field.path];
        schema.erase(field.path);
        CHECK(described.value("type", "") == field.type);
        CHECK(described.value("title", "") != "");
        CHECK(described.value("description", "") == field.description);
        CHECK(described.value("unit", "") == field.unit);
        const std::string value = field.default_value.empty() ? "null" : field.default_value;
        CHECK(described.value("default", json()) == json::parse(value));  // 5 and 5.0 are equal
        CHECK(described.value("enum", std::vector<std::string>()) == field.choices);
        const bool list = field.type == "array";
        CHECK(described.contains("minimum") == is_numeric(field));
        if (is_numeric(field) || list) {
            CHECK(described.value(list ? "minItems" : "minimum", -1.0) == field.low);
            CHECK(described.value(list ? "maxItems" : "maximum", -1.0) == field.high);
        }
    }
    for (const auto& [path, unknown] : schema) {
        FAIL_CHECK("the schema describes a key that nobody reads: " << path);
    }
}
