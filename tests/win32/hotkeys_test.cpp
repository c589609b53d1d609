// SPDX-License-Identifier: MIT
#include "daemon/win32/hotkeys.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>

using namespace hyrax;
using namespace hyrax::win32;

TEST_CASE("keys have the system's codes") {
    const std::pair<std::string, UINT> codes[] = {
        {"ctrl+a", 'A'},
        {"ctrl+z", 'Z'},
        {"ctrl+0", '0'},
        {"ctrl+9", '9'},
        {"f1", VK_F1},
        {"f24", VK_F24},
        {"ctrl+space", VK_SPACE},
        {"ctrl+tab", VK_TAB},
        {"ctrl+enter", VK_RETURN},
        {"ctrl+escape", VK_ESCAPE},
        {"ctrl+insert", VK_INSERT},
        {"ctrl+delete", VK_DELETE},
        {"ctrl+home", VK_HOME},
        {"ctrl+end", VK_END},
        {"ctrl+pageup", VK_PRIOR},
        {"ctrl+pagedown", VK_NEXT},
        {"ctrl+left", VK_LEFT},
        {"ctrl+right", VK_RIGHT},
        {"ctrl+up", VK_UP},
        {"ctrl+down", VK_DOWN},
    };
    for (const auto& [text, code] : codes) {
        CAPTURE(text);
        CHECK(virtual_key(parse_keys(text).value().key) == code);
    }
}

TEST_CASE("a hotkey is had once, and free again when it is given back or its owner goes") {
    const KeyCombination keys = parse_keys("ctrl+alt+shift+f11").value();
    Hotkeys others(nullptr);
    {
        Hotkeys ours(nullptr);
        CHECK(ours.take(1, keys));
        const Result<void> refused = others.take(2, keys);
        REQUIRE_FALSE(refused);
        CHECK(refused.error().message == "another program, or Windows itself, has it");
        ours.give_back(1);
        CHECK(others.take(2, keys));
        others.give_back(2);
        others.give_back(2);
        CHECK(ours.take(3, keys));
    }
    CHECK(others.take(4, keys));
}
