// SPDX-License-Identifier: MIT
#include "daemon/core/key_combination.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>

using namespace hyrax;

TEST_CASE("keys are read in any order and spelled in one") {
    const std::pair<std::string, std::string> texts[] = {
        {"Alt + CTRL+h", "ctrl+alt+h"},
        {"win+shift+alt+ctrl+7", "ctrl+alt+shift+win+7"},
        {"F24", "f24"},
        {"shift+f1", "shift+f1"},
        {"ctrl+space", "ctrl+space"},
        {"alt+down", "alt+down"},
        {"ctrl+delete", "ctrl+delete"},
        {"win+PageUp", "win+pageup"},
    };
    for (const auto& [text, spelled] : texts) {
        CAPTURE(text);
        const Result<KeyCombination> keys = parse_keys(text);
        REQUIRE(keys);
        CHECK(text_of(*keys) == spelled);
        CHECK(parse_keys(spelled).value() == *keys);
    }
    CHECK(parse_keys("ctrl+delete")->key == Key::del);
    CHECK(parse_keys("ctrl+down")->key == Key::down);
    CHECK(parse_keys("f24")->key == Key::f24);
    CHECK(parse_keys("alt+q")->key == static_cast<Key>('q'));
}

TEST_CASE("what are no keys is explained") {
    for (const char* const text : {"", "ctrl+", "f0", "f25", "f01", "f1x", "ctrl+ab", "ctrl+-"}) {
        CAPTURE(text);
        CHECK(parse_keys(text).error().message.contains("is no key"));
    }
    CHECK(parse_keys("hyper+h").error().message.contains("'hyper' is not one of"));
    CHECK(parse_keys("shift+h").error().message.contains("needs ctrl, alt or win"));
}
