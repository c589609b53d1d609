// SPDX-License-Identifier: MIT
#include "daemon/core/located_json.h"

#include <doctest/doctest.h>

#include <string>

using namespace hyrax;

namespace {

LocatedJson parsed(std::string_view text) {
    const Result<LocatedJson> json = parse_located_json(text, "f");
    if (!json) {
        FAIL(json.error().message);
    }
    return *json;
}

std::string complaint(std::string_view text) {
    const Result<LocatedJson> json = parse_located_json(text, "f");
    return json ? "parsed it" : json.error().message;
}

std::string repeated(std::string_view text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i) {
        result += text;
    }
    return result;
}

}  // namespace

TEST_CASE("json: values and keys know where they begin") {
    const LocatedJson root = parsed("{\n"
                                    "  \"a\": 12,\n"
                                    "  \"b\" : [ -0.5e1, \"x\\\"y\", true,\n"
                                    "\tnull, {}, [] ],\n"
                                    "  \"c\":{\"d\":false}\n"
                                    "}");
    CHECK(root.at == TextPosition{1, 1});
    const LocatedJson* a = root.member("a");
    REQUIRE(a);
    CHECK(a->key_at == TextPosition{2, 3});
    CHECK(a->at == TextPosition{2, 8});
    CHECK(a->value == 12);
    CHECK(a->source == "12");
    const LocatedJson* b = root.member("b");
    REQUIRE(b);
    CHECK(b->at == TextPosition{3, 9});
    REQUIRE(b->children.size() == 6);
    CHECK(b->children[0].at == TextPosition{3, 11});
    CHECK(b->children[0].value == -5.0);
    CHECK(b->children[0].source == "-0.5e1");
    CHECK(b->children[1].at == TextPosition{3, 19});
    CHECK(b->children[1].value == "x\"y");
    CHECK(b->children[1].source == "\"x\\\"y\"");
    CHECK(b->children[2].at == TextPosition{3, 27});
    CHECK(b->children[3].at == TextPosition{4, 2});
    CHECK(b->children[4].at == TextPosition{4, 8});
    CHECK(b->children[4].value.is_object());
    CHECK(b->children[5].at == TextPosition{4, 12});
    CHECK(b->children[5].value.is_array());
    const LocatedJson* c = root.member("c");
    REQUIRE(c);
    CHECK(c->at == TextPosition{5, 7});
    REQUIRE(c->member("d"));
    CHECK(c->member("d")->at == TextPosition{5, 12});
    CHECK(root.member("d") == nullptr);
}

TEST_CASE("json: comments, marks in strings and wide characters do not confuse positions") {
    const LocatedJson root =
        parsed("\xEF\xBB\xBF// {\"no\": 1}\r\n"
               "/* , : \" */ { /**/ \"a,:/*\" /*:*/ : // x\n"
               "  \"\xC3\xA4\xE5\xB2\xA9\xF0\x9F\x90\xB9\", \"b\": 1 } // end");
    CHECK(root.at == TextPosition{2, 13});
    REQUIRE(root.children.size() == 2);
    CHECK(root.children[0].key == "a,:/*");
    CHECK(root.children[0].key_at == TextPosition{2, 20});
    CHECK(root.children[0].at == TextPosition{3, 3});
    CHECK(root.children[1].key_at == TextPosition{3, 10});  // the text is 3 characters, 9 bytes
}

TEST_CASE("json: any value may be the root") {
    CHECK(parsed(" 5 ").value == 5);
    CHECK(parsed("\"\\u00e4\"").value == "\xC3\xA4");
    CHECK(parsed("[]").value.is_array());
    CHECK(parsed("0").at == TextPosition{1, 1});
}

TEST_CASE("json: syntax errors in plain words, at the place where something is wrong") {
    CHECK(complaint("") == "f: the file is empty; at least {} is needed");
    CHECK(complaint(" \n // nothing\n") == "f: the file is empty; at least {} is needed");
    CHECK(
        complaint("{") == "f:1:2: expected a key in double quotes or }, found the end of the file"
    );
    CHECK(complaint("{a: 1}") == "f:1:2: expected a key in double quotes or }, found a");
    CHECK(complaint("{\"a\" 1}") == "f:1:6: expected a : between key and value, found 1");
    CHECK(complaint("{\"a\": }") == "f:1:7: expected a value, found }");
    CHECK(complaint("{\"a\": 1 \"b\": 2}") == "f:1:9: expected a comma or }, found \"b");
    CHECK(complaint("{\"a\": 1,\n}") == "f:2:1: a comma before } is not allowed");
    CHECK(complaint("{\"a\": 1,, }") == "f:1:9: expected a key in double quotes, found ,");
    CHECK(complaint("{\"a\": 1]") == "f:1:8: expected a comma or }, found ]");
    CHECK(complaint("[1 2]") == "f:1:4: expected a comma or ], found 2");
    CHECK(complaint("[1,]") == "f:1:4: a comma before ] is not allowed");
    CHECK(complaint("[,1]") == "f:1:2: expected a value, found ,");
    CHECK(complaint("[1") == "f:1:3: expected a comma or ], found the end of the file");
    CHECK(complaint("{} x") == "f:1:4: expected the end of the file, found x");
    CHECK(complaint("{}\n{}") == "f:2:1: expected the end of the file, found {");
    CHECK(complaint("[/* x") == "f:1:2: this comment is not closed: */ is missing");
    CHECK(complaint("[1, /* x") == "f:1:5: this comment is not closed: */ is missing");
    CHECK(complaint("[] /* x") == "f:1:4: this comment is not closed: */ is missing");
}

TEST_CASE("json: wrong words and numbers") {
    CHECK(complaint("[high]") == "f:1:2: expected a value, found high; a text needs double quotes");
    CHECK(complaint("['a']") == "f:1:2: expected a value, found 'a'; a text needs double quotes");
    CHECK(complaint("[True]") == "f:1:2: expected a value, found True; a text needs double quotes");
    CHECK(complaint("[truer]") == "f:1:6: expected a comma or ], found r");
    CHECK(complaint("[01]") == "f:1:3: expected a comma or ], found 1");
    for (const char* number : {".5", "1.", "-", "+1", "1e", "-.5"}) {
        CHECK(
            complaint("[" + std::string(number) + "]") ==
            "f:1:2: " + std::string(number) +
                " is no number that JSON knows (such as 12, -0.5 or 1e3)"
        );
    }
    CHECK(complaint("[1e999]") == "f:1:2: the number 1e999 is too large");
    CHECK(
        complaint("[" + std::string(1000, 'x') + "]") ==
        "f:1:2: expected a value, found " + std::string(30, 'x') + "...; a text needs double quotes"
    );
}

TEST_CASE("json: wrong texts") {
    CHECK(complaint("[\"abc]\n") == "f:1:2: the closing \" of this text is missing on its line");
    CHECK(complaint("[\"abc\n\"]") == "f:1:2: the closing \" of this text is missing on its line");
    CHECK(
        complaint("{\"a\": 1,\n \"b: 2}") ==
        "f:2:2: the closing \" of this text is missing on its line"
    );
    CHECK(
        complaint("[\"C:\\Users\"]") ==
        "f:1:5: a \\ that begins no escape; write \\\\ for a backslash"
    );
    CHECK(complaint("[\"a\tb\"]") == "f:1:4: a control character (0x09) inside a text");
    CHECK(complaint("[\"\\ud800\"]") == "f:1:2: a \\u escape in this text names no character");
    CHECK(complaint("[\"\\u12\"]") == "f:1:2: a \\u escape in this text names no character");
}

TEST_CASE("json: bytes that are not UTF-8 are refused, in comments as well") {
    const std::string hint = " is not UTF-8; save the file as UTF-8";
    CHECK(complaint("{\n \"a\": \"\xE9\"}") == "f:2:8: byte 0xE9" + hint);
    CHECK(complaint("{} // \xE4") == "f:1:7: byte 0xE4" + hint);
    CHECK(complaint("\xFF\xFE{") == "f:1:1: byte 0xFF" + hint);  // Notepad's "Unicode"
    for (const char* wrong : {
             "\xC0\x80",          // overlong
             "\xE0\x80\x80",      // overlong
             "\xED\xA0\x80",      // surrogate
             "\xF4\x90\x80\x80",  // above U+10FFFF
             "\xF5\x80\x80\x80",  // far above
             "\xF0\x9F\x90",      // cut off
             "\x80",              // no first byte
         }) {
        CHECK(complaint(wrong).ends_with(hint));
    }
    using namespace std::string_view_literals;
    // The parser takes a zero for the end and would hide the rest.
    CHECK(complaint("{}\0 garbage"sv) == "f:1:3: a zero byte; this is not a text file in UTF-8");
}

TEST_CASE("json: a key comes once in its object") {
    CHECK(
        complaint("{\"a\": 1,\n \"b\": 2,\n \"\\u0061\": 3}") ==
        "f:3:2: the key \"a\" is already in this object, in line 1"
    );
    CHECK(complaint("{\"a\": {\"a\": {}}, \"b\": [{\"a\": 1}, {\"a\": 1}]}") == "parsed it");
}

TEST_CASE("json: nesting has a limit") {
    const int limit = static_cast<int>(max_json_depth);
    CHECK(complaint(repeated("[", limit) + repeated("]", limit)) == "parsed it");
    CHECK(
        complaint(repeated("[", limit + 1) + repeated("]", limit + 1)) ==
        "f:1:65: nested more than 64 deep"
    );
    CHECK(complaint(repeated("[", 10'000)) == "f:1:65: nested more than 64 deep");
    CHECK(complaint(repeated("{\"a\":", 10'000)) == "f:1:321: nested more than 64 deep");
}

TEST_CASE("json: a large file of many keys is read in a blink, positions included") {
    std::string text = "{";
    for (int i = 0; i < 60'000; ++i) {
        text += (i == 0 ? "\"k" : ",\n\"k") + std::to_string(i) + "\": 1";
    }
    const LocatedJson root = parsed(text + "}");
    CHECK(root.children.size() == 60'000);
    CHECK(root.children.back().key_at == TextPosition{60'000, 1});
}
