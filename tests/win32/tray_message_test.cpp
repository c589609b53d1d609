// SPDX-License-Identifier: MIT
#include "daemon/win32/tray_message.h"

#include <doctest/doctest.h>

using namespace hyrax;
using hyrax::win32::menu_anchor;

namespace {

constexpr std::int64_t icon_one = 1 << 16;

}  // namespace

TEST_CASE("both buttons and the keyboard open the menu at the anchor") {
    constexpr std::uint64_t at = (700U << 16U) | 1500U;
    for (const std::int64_t event : {0x007B, 0x0400, 0x0401}) {
        CHECK(menu_anchor(at, icon_one | event) == Point{1500, 700});
    }
}

TEST_CASE("an anchor may lie at negative coordinates") {
    CHECK(menu_anchor(0xFF38'F9C0U, icon_one | 0x007B) == Point{-1600, -200});
}

TEST_CASE("other events open nothing") {
    for (const std::int64_t event :
         {0x0200, 0x0201, 0x0202, 0x0203, 0x0204, 0x0205, 0x0402, 0x0405}) {
        CHECK_FALSE(menu_anchor(0, icon_one | event));
    }
}
