// SPDX-License-Identifier: MIT
// Keys that are pressed together, and how they are spelled.
#pragma once

#include "daemon/core/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace hyrax {

/// Letters, small ones, and digits are their ASCII codes; f1 to f24 and the named keys follow one
/// another.
enum class Key : std::uint8_t {
    f1 = 128,
    f24 = f1 + 23,
    space,
    tab,
    enter,
    escape,
    insert,
    del,
    home,
    end,
    page_up,
    page_down,
    left,
    right,
    up,
    down,
};

struct KeyCombination {
    bool ctrl = false;
    bool alt = false;
    bool shift = false;
    bool win = false;
    Key key = Key::space;
    bool operator==(const KeyCombination&) const = default;
};

/// "Alt + CTRL+h": any modifiers of ctrl, alt, shift and win, then one key: a letter, a digit, f1
/// to f24, space, tab, enter, escape, insert, delete, home, end, pageup, pagedown, left, right, up
/// or down. A key other than f1 to f24 needs ctrl, alt or win: without one it would be lost for
/// typing.
[[nodiscard]] Result<KeyCombination> parse_keys(std::string_view text);

/// "ctrl+alt+h": the modifiers in the order ctrl, alt, shift, win.
[[nodiscard]] std::string text_of(const KeyCombination& keys);

}  // namespace hyrax
