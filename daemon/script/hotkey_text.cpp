// SPDX-License-Identifier: MIT
#include "daemon/script/hotkey_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace hyrax::script {
namespace {

constexpr std::array<std::string_view, 4> modifiers{"ctrl", "alt", "shift", "win"};
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

// The parts between the pluses, in small letters and without blanks.
std::vector<std::string> parts_of(std::string_view text) {
    std::vector<std::string> parts(1);
    for (const char letter : text) {
        if (letter == '+') {
            parts.emplace_back();
        } else if (letter >= 'A' && letter <= 'Z') {
            parts.back() += static_cast<char>(letter - 'A' + 'a');
        } else if (letter != ' ') {
            parts.back() += letter;
        }
    }
    return parts;
}

bool is_function_key(std::string_view key) {
    if (key.size() < 2 || key.size() > 3 || key[0] != 'f') {
        return false;
    }
    int number = 0;
    for (const char digit : key.substr(1)) {
        if (digit < '0' || digit > '9') {
            return false;
        }
        number = number * 10 + (digit - '0');
    }
    return key[1] != '0' && number <= 24;
}

bool is_plain_key(std::string_view key) {
    const bool is_character =
        key.size() == 1 && ((key[0] >= 'a' && key[0] <= 'z') || (key[0] >= '0' && key[0] <= '9'));
    return is_character || std::ranges::find(named_keys, key) != named_keys.end();
}

}  // namespace

Result<std::string> normal_hotkey(std::string_view text) {
    std::vector<std::string> parts = parts_of(text);
    const std::string key = parts.back();
    parts.pop_back();
    std::array<bool, modifiers.size()> held{};
    for (const std::string& part : parts) {
        const auto found = std::ranges::find(modifiers, part);
        if (found == modifiers.end()) {
            return failure(fmt::format(
                "'{}' is not one of {} (as in \"ctrl+alt+h\")", part, fmt::join(modifiers, ", ")
            ));
        }
        held.at(static_cast<std::size_t>(found - modifiers.begin())) = true;
    }
    if (!is_function_key(key) && !is_plain_key(key)) {
        return failure(fmt::format(
            "'{}' is no key: there are a to z, 0 to 9, f1 to f24, {}",
            key,
            fmt::join(named_keys, ", ")
        ));
    }
    if (!is_function_key(key) && !held[0] && !held[1] && !held[3]) {
        return failure(fmt::format("'{}' needs ctrl, alt or win beside it", key));
    }
    std::string normal;
    for (std::size_t i = 0; i < modifiers.size(); ++i) {
        if (held.at(i)) {
            normal += std::string(modifiers.at(i)) + "+";
        }
    }
    return normal + key;
}

}  // namespace hyrax::script
