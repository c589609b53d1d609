// SPDX-License-Identifier: MIT
#include "daemon/script/text.h"

namespace hyrax::script {
namespace {

bool is_control(char letter) {
    const auto byte = static_cast<unsigned char>(letter);
    return byte < 0x20U || byte == 0x7FU;
}

// Length of the character at the front, 0 if it is not UTF-8 (RFC 3629: shortest form, no
// surrogates, up to U+10FFFF).
std::size_t character_length(std::string_view text) {
    const auto byte = [&text](std::size_t i) {
        return i < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[i])) : 0U;
    };
    const auto follows = [&byte](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
    const unsigned first = byte(0);
    if (first < 0x80U) {
        return 1;
    }
    if (first >= 0xC2U && first <= 0xDFU) {
        return follows(1) ? 2 : 0;
    }
    if (first >= 0xE0U && first <= 0xEFU) {
        const bool shortest = first != 0xE0U || byte(1) >= 0xA0U;
        const bool no_surrogate = first != 0xEDU || byte(1) < 0xA0U;
        return shortest && no_surrogate && follows(1) && follows(2) ? 3 : 0;
    }
    if (first >= 0xF0U && first <= 0xF4U) {
        const bool shortest = first != 0xF0U || byte(1) >= 0x90U;
        const bool in_range = first != 0xF4U || byte(1) < 0x90U;
        return shortest && in_range && follows(1) && follows(2) && follows(3) ? 4 : 0;
    }
    return 0;
}

}  // namespace

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        if (length == 0) {
            return false;
        }
        text.remove_prefix(length);
    }
    return true;
}

bool is_plain_text(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        if (length == 0 || is_control(text.front())) {
            return false;
        }
        text.remove_prefix(length);
    }
    return true;
}

std::string clean_text(std::string_view text, std::size_t longest) {
    constexpr std::string_view cut = "...";
    std::string clean;
    bool after_control = false;
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        const bool control = is_control(text.front());
        std::string_view piece = length == 0 ? "?" : text.substr(0, length);
        if (control) {
            piece = after_control ? "" : " ";
        }
        if (clean.size() + piece.size() > longest) {
            while (clean.size() + cut.size() > longest && !clean.empty()) {
                // Whole characters: continuation bytes go with their first one.
                while (clean.size() > 1 &&
                       (static_cast<unsigned char>(clean.back()) & 0xC0U) == 0x80U) {
                    clean.pop_back();
                }
                clean.pop_back();
            }
            return clean.append(cut);
        }
        clean.append(piece);
        after_control = control;
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return clean;
}

}  // namespace hyrax::script
