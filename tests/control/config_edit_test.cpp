// SPDX-License-Identifier: MIT
#include "daemon/control/config_edit.h"

#include "daemon/control/config_key.h"
#include "daemon/core/config.h"
#include "daemon/core/files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace hyrax;

namespace {

std::string edited(std::string_view text, std::string_view pointer, std::string_view value) {
    const Result<std::string> changed = with_value(text, pointer, value, "config.json");
    return changed ? *changed : "failed: " + changed.error().message;
}

std::size_t comments_in(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t at = text.find("//"); at != text.npos; at = text.find("//", at + 2)) {
        ++count;
    }
    return count;
}

std::string shipped() {
    const std::filesystem::path folder = HYRAX_SOURCE_DIR;
    return read_text_file(folder / "config" / "config.json", 1U << 20U).value();
}

}  // namespace

TEST_CASE("a value is replaced where it stands, and nothing else changes") {
    CHECK(
        edited(
            "{ // a\n  \"physics\": {\"gravity\" :  12e2 /* b */, \"x\": [1,\n 2]} }",
            "/physics/gravity",
            "300"
        ) == "{ // a\n  \"physics\": {\"gravity\" :  300 /* b */, \"x\": [1,\n 2]} }"
    );
    CHECK(
        edited(R"({"a": {"b": [1, {"c": 2}], "d": 3}})", "/a/b", "[]") ==
        R"({"a": {"b": [], "d": 3}})"
    );
    CHECK(edited(R"({"a": "x\"y"})", "/a", "1") == R"({"a": 1})");
    CHECK(edited("\r\n{\"\\u0061\": 1}\r\n", "/a", "2") == "\r\n{\"\\u0061\": 2}\r\n");
}

TEST_CASE("a key that is missing comes first in its object") {
    CHECK(edited("{}", "/a", "1") == R"({"a": 1})");
    CHECK(edited("{ // nothing\n}", "/a/b/c", "1") == "{\"a\": {\"b\": {\"c\": 1}} // nothing\n}");
    CHECK(edited(R"({"a": 1})", "/b", "2") == R"({"b": 2, "a": 1})");
    CHECK(edited(R"({"a": {"x": 1}})", "/a/y", "2") == R"({"a": {"y": 2, "x": 1}})");
    const std::string laid_out = "{\n  // speed\n  \"a\": 1, // fast\n  \"b\": 2\n}\n";
    CHECK(
        edited(laid_out, "/c", "3") ==
        "{\n  \"c\": 3,\n  // speed\n  \"a\": 1, // fast\n  \"b\": 2\n}\n"
    );
    CHECK(
        edited("{ // all\r\n\t\"a\": 1\r\n}", "/c", "3") ==
        "{ // all\r\n\t\"c\": 3,\r\n\t\"a\": 1\r\n}"
    );
    CHECK(edited("{ /* x */\n  \"a\": 1\n}", "/c", "3") == "{\"c\": 3,  /* x */\n  \"a\": 1\n}");
}

TEST_CASE("what cannot be edited is told with its place") {
    CHECK(
        edited("{\"a\": 5}", "/a/b", "1") ==
        "failed: config.json:1:7: /a: is no object, so that /b cannot be in it"
    );
    CHECK(
        edited("[]", "/a", "1") ==
        "failed: config.json:1:1: : is no object, so that /a cannot be in it"
    );
    CHECK(edited("{\"a\": ", "/a", "1").starts_with("failed: config.json:1:7: "));
    CHECK(edited("", "/a", "1").starts_with("failed: config.json: the file is empty"));
}

TEST_CASE("every setting of the shipped config can be set, and no comment is lost") {
    const std::string before = shipped();
    for (const ConfigField& field : settable(config_fields())) {
        INFO(field.path);
        const std::string value =
            field.choices.empty() ? field.default_value : "\"" + field.choices.back() + "\"";
        const std::string after = edited(before, field.path, value);
        REQUIRE(parse_config(after, "config.json").has_value());
        CHECK(comments_in(after) == comments_in(before));
        // And with nothing but braces around it.
        const std::string small = edited("{}", field.path, value);
        CHECK(parse_config(small, "config.json").has_value());
        CHECK(parse_config(small, "config.json")->warnings.empty());
    }
}

TEST_CASE("settings have two spellings") {
    CHECK(pointer_of("physics.gravity") == "/physics/gravity");
    CHECK(pointer_of("/physics/gravity") == "/physics/gravity");
    CHECK(dotted("/physics/gravity") == "physics.gravity");
    const std::vector<std::string> keys = settable_keys();
    CHECK(std::ranges::count(keys, "overlay.fps") == 1);
    CHECK(std::ranges::count_if(keys, [](const std::string& key) {
              return key.contains('$');
          }) == 0);
}
