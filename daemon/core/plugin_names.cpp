// SPDX-License-Identifier: MIT
#include "daemon/core/plugin_names.h"

#include "daemon/core/file_name.h"
#include "daemon/core/plugin.h"

#include <algorithm>

namespace hyrax {
namespace {

constexpr std::size_t longest_version = 100;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_small(char c) {
    return c >= 'a' && c <= 'z';
}

// Names joined by dots, as they follow - and + in a version.
bool are_labels(std::string_view text, bool counts_only) {
    const auto is_letter = [](char c) {
        return is_digit(c) || is_small(c) || (c >= 'A' && c <= 'Z') || c == '-';
    };
    const bool ends_well = !text.empty() && !text.ends_with('.');
    while (!text.empty()) {
        const std::string_view part = take_part(text, '.');
        const bool number = !part.empty() && std::ranges::all_of(part, is_digit);
        if (part.empty() || !std::ranges::all_of(part, is_letter) ||
            (counts_only && number && part.size() > 1 && part[0] == '0')) {
            return false;
        }
    }
    return ends_well;
}

}  // namespace

std::string_view take_part(std::string_view& text, char mark) {
    const std::size_t end = std::min(text.find(mark), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return part;
}

bool is_count(std::string_view text) {
    return !text.empty() && text.size() <= 9 && std::ranges::all_of(text, is_digit) &&
           (text.size() == 1 || text[0] != '0');
}

bool is_version(std::string_view text) {
    if (text.size() > longest_version) {
        return false;
    }
    if (const std::size_t plus = text.find('+'); plus != std::string_view::npos) {
        if (!are_labels(text.substr(plus + 1), false)) {
            return false;
        }
        text = text.substr(0, plus);
    }
    if (const std::size_t hyphen = text.find('-'); hyphen != std::string_view::npos) {
        if (!are_labels(text.substr(hyphen + 1), true)) {
            return false;
        }
        text = text.substr(0, hyphen);
    }
    return std::ranges::count(text, '.') == 2 && is_count(take_part(text, '.')) &&
           is_count(take_part(text, '.')) && is_count(text);
}

bool is_line(std::string_view text, std::size_t longest) {
    return !text.empty() && text.size() <= longest &&
           std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

bool is_setting_key(std::string_view text) {
    return !text.empty() && text.size() <= 64 && is_small(text[0]) && text != "enabled" &&
           std::ranges::all_of(text, [](char c) { return is_small(c) || is_digit(c) || c == '_'; });
}

bool is_kind_name(std::string_view text) {
    constexpr std::size_t longest = 23;
    return !text.empty() && text.size() <= longest && text[0] != '-' && text[0] != '_' &&
           std::ranges::all_of(text, [](char c) {
               return is_small(c) || is_digit(c) || c == '-' || c == '_';
           });
}

bool is_plugin_id(std::string_view text) {
    const auto fits = [](char c) { return is_small(c) || is_digit(c); };
    return text.size() >= 3 && text.size() <= 40 && fits(text.front()) && fits(text.back()) &&
           std::ranges::all_of(text, [&](char c) { return fits(c) || c == '-'; }) &&
           !names_device(text) && text != "user";
}

}  // namespace hyrax
