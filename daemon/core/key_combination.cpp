// SPDX-License-Identifier: MIT
#include "daemon/core/key_combination.h"

#include "daemon/core/ascii.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace hyrax {
namespace {

struct Modifier {
    std::string_view name;
    bool KeyCombination::*held;
};

constexpr std::array<Modifier, 4> modifiers{{
    {"ctrl", &KeyCombination::ctrl},
    {"alt", &KeyCombination::alt},
    {"shift", &KeyCombination::shift},
    {"win", &KeyCombination::win},
}};

// From Key::space on.
constexpr std::array<std::string_view, 14> named_keys{
    "space",
    "tab",
    "enter",
    "escape",
    "insert",
    "delete",
    "home",
    "end",
    "pageup",
    "pagedown",
    "left",
    "right",
    "up",
    "down"
};

Key key_at(Key first, std::ptrdiff_t offset) {
    return static_cast<Key>(std::to_underlying(first) + offset);
}

bool is_function_key(Key key) {
    return key >= Key::f1 && key <= Key::f24;
}

// The parts between the pluses, in small letters and without blanks.
std::vector<std::string> parts_of(std::string_view text) {
    std::vector<std::string> parts(1);
    for (const char letter : text) {
        if (letter == '+') {
            parts.emplace_back();
        } else if (letter != ' ') {
            parts.back() += lower_ascii(letter);
        }
    }
    return parts;
}

std::optional<Key> function_key(std::string_view name) {
    int number = 0;
    const char* const end = name.data() + name.size();
    if (name.size() < 2 || name[0] != 'f' || name[1] == '0') {
        return std::nullopt;
    }
    const auto read = std::from_chars(name.data() + 1, end, number);
    if (read.ec != std::errc() || read.ptr != end || number < 1 || number > 24) {
        return std::nullopt;
    }
    return key_at(Key::f1, number - 1);
}

std::optional<Key> key_named(std::string_view name) {
    if (name.size() == 1 &&
        ((name[0] >= 'a' && name[0] <= 'z') || (name[0] >= '0' && name[0] <= '9'))) {
        return static_cast<Key>(name[0]);
    }
    const auto named = std::ranges::find(named_keys, name);
    return named != named_keys.end() ? key_at(Key::space, named - named_keys.begin())
                                     : function_key(name);
}

std::string name_of(Key key) {
    if (is_function_key(key)) {
        return fmt::format("f{}", std::to_underlying(key) - std::to_underlying(Key::f1) + 1);
    }
    if (key >= Key::space) {
        const int place = std::to_underlying(key) - std::to_underlying(Key::space);
        return std::string(named_keys.at(static_cast<std::size_t>(place)));
    }
    return {static_cast<char>(key)};
}

}  // namespace

Result<KeyCombination> parse_keys(std::string_view text) {
    std::vector<std::string> parts = parts_of(text);
    const std::string name = parts.back();
    parts.pop_back();
    KeyCombination keys;
    for (const std::string& part : parts) {
        const auto found = std::ranges::find(modifiers, part, &Modifier::name);
        if (found == modifiers.end()) {
            return failure(
                fmt::format("'{}' is not one of ctrl, alt, shift, win (as in \"ctrl+alt+h\")", part)
            );
        }
        keys.*found->held = true;
    }
    const std::optional<Key> key = key_named(name);
    if (!key) {
        return failure(fmt::format(
            "'{}' is no key: there are a to z, 0 to 9, f1 to f24, {}",
            name,
            fmt::join(named_keys, ", ")
        ));
    }
    keys.key = *key;
    if (!is_function_key(*key) && !keys.ctrl && !keys.alt && !keys.win) {
        return failure(fmt::format("'{}' needs ctrl, alt or win beside it", name));
    }
    return keys;
}

std::string text_of(const KeyCombination& keys) {
    std::string text;
    for (const Modifier& modifier : modifiers) {
        if (keys.*modifier.held) {
            text += std::string(modifier.name) + "+";
        }
    }
    return text + name_of(keys.key);
}

}  // namespace hyrax
