// SPDX-License-Identifier: MIT
#include "daemon/core/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>

namespace hyrax {
namespace {

unsigned byte_at(std::string_view text, std::size_t offset) {
    return static_cast<unsigned char>(text[offset]);
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// Length of the character at the start, or 0. The second byte's range shuts out overlong forms,
// surrogates and numbers above U+10FFFF (Unicode standard, table 3-7).
std::size_t utf8_length(std::string_view text) {
    const unsigned first = byte_at(text, 0);
    if (first < 0x80) {
        return 1;
    }
    const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    if (first < 0xC2 || first > 0xF4 || text.size() < length) {
        return 0;
    }
    const unsigned low = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
    const unsigned high = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
    if (byte_at(text, 1) < low || byte_at(text, 1) > high) {
        return 0;
    }
    for (std::size_t i = 2; i < length; ++i) {
        if ((byte_at(text, i) & 0xC0U) != 0x80) {
            return 0;
        }
    }
    return length;
}

std::size_t comment_length(std::string_view text) {
    if (text.starts_with("//")) {
        return std::min(text.find('\n'), text.size());
    }
    if (text.starts_with("/*")) {
        const std::size_t end = text.find("*/", 2);
        return end == std::string_view::npos ? 0 : end + 2;
    }
    return 0;
}

std::size_t digits(std::string_view text, std::size_t from) {
    std::size_t end = from;
    while (end < text.size() && is_digit(text[end])) {
        ++end;
    }
    return end;
}

// By JSON's grammar, so that "01" is the number 0 with something behind it, as for the parser.
std::size_t number_length(std::string_view text) {
    std::size_t end = text.starts_with('-') ? 1 : 0;
    end = text.substr(end).starts_with('0') ? end + 1 : digits(text, end);
    if (text.substr(end).starts_with('.')) {
        end = digits(text, end + 1);
    }
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        ++end;
        end += end < text.size() && (text[end] == '+' || text[end] == '-') ? 1 : 0;
        end = digits(text, end);
    }
    return end;
}

}  // namespace

void TextCursor::advance(std::size_t bytes) {
    for (const char c : text_.substr(offset_, bytes)) {
        if (c == '\n') {
            ++position_.line;
            position_.column = 1;
        } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80) {  // not inside a character
            ++position_.column;
        }
        ++offset_;
    }
}

void TextCursor::skip_blanks() {
    while (!at_end()) {
        const char c = peek();
        const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
        const std::size_t length = space ? 1 : comment_length(rest());
        if (length == 0) {
            return;
        }
        advance(length);
    }
}

void TextCursor::skip_to_token() {
    skip_blanks();
    while (peek() == ',' || peek() == ':') {
        advance(1);
        skip_blanks();
    }
}

std::string_view TextCursor::take_string() {
    const std::string_view from = rest();
    std::size_t end = 1;
    while (end < from.size() && from[end] != '"') {
        end += from[end] == '\\' ? 2 : 1;
    }
    end = std::min(end + 1, from.size());
    advance(end);
    return from.substr(0, end);
}

std::string_view TextCursor::take_scalar() {
    const std::string_view from = rest();
    std::size_t length = number_length(from);
    for (const std::string_view word : {"true", "false", "null"}) {
        length = from.starts_with(word) ? word.size() : length;
    }
    advance(length);
    return from.substr(0, length);
}

std::string shortened(std::string_view text, std::size_t longest) {
    if (text.size() <= longest) {
        return std::string(text);
    }
    std::size_t end = longest;
    while (end > 0 && (byte_at(text, end) & 0xC0U) == 0x80) {
        --end;
    }
    return std::string(text.substr(0, end)) + "...";
}

std::optional<TextFault> encoding_fault(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t length = utf8_length(text.substr(at));
        if (length == 0) {
            return TextFault{
                at,
                fmt::format("byte 0x{:02X} is not UTF-8; save the file as UTF-8", byte_at(text, at))
            };
        }
        // The parser would take a zero for the end and ignore the rest.
        if (text[at] == '\0') {
            return TextFault{at, "a zero byte; this is not a text file in UTF-8"};
        }
        at += length;
    }
    return std::nullopt;
}

std::optional<TextFault> string_fault(std::string_view text) {
    constexpr std::string_view escapes = "\"\\/bfnrtu";
    std::size_t at = 1;
    while (at < text.size() && text[at] != '"' && text[at] != '\n' && text[at] != '\r') {
        if (byte_at(text, at) < 0x20) {
            return TextFault{
                at, fmt::format("a control character (0x{:02X}) inside a text", byte_at(text, at))
            };
        }
        if (text[at] == '\\') {
            if (at + 1 == text.size() || !escapes.contains(text[at + 1])) {
                return TextFault{at, "a \\ that begins no escape; write \\\\ for a backslash"};
            }
            ++at;
        }
        ++at;
    }
    if (at >= text.size() || text[at] != '"') {
        return TextFault{0, "the closing \" of this text is missing on its line"};
    }
    return std::nullopt;
}

}  // namespace hyrax
