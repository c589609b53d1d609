// SPDX-License-Identifier: MIT
// A position that walks over JSON text, token by token, and counts lines and columns.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace hyrax {

/// Counted from 1, as editors do. A column is a character, not a byte.
struct TextPosition {
    std::size_t line = 1;
    std::size_t column = 1;
    bool operator==(const TextPosition&) const = default;
};

/// Does not judge the text: it finds where tokens begin and end, in text that a parser has accepted
/// up to there, and describes what follows.
class TextCursor {
public:
    explicit TextCursor(std::string_view text) : text_(text) {}

    TextPosition position() const { return position_; }
    std::size_t offset() const { return offset_; }
    bool at_end() const { return offset_ == text_.size(); }
    /// The next byte; 0 at the end.
    char peek() const { return at_end() ? '\0' : text_[offset_]; }
    std::string_view rest() const { return text_.substr(offset_); }

    void advance(std::size_t bytes);
    /// Over white space and comments. Stops before a comment that does not end.
    void skip_blanks();
    /// Over blanks and the marks between two values: comma and colon.
    void skip_to_token();
    /// Over a string in quotes; returns it, quotes included.
    std::string_view take_string();
    /// Over a number or one of the words true, false and null; returns it.
    std::string_view take_scalar();

private:
    std::string_view text_;
    std::size_t offset_ = 0;
    TextPosition position_;
};

/// At most `longest` bytes of UTF-8 text, cut between characters; "..." tells of a cut.
std::string shortened(std::string_view text, std::size_t longest);

/// Something wrong at so many bytes after the start of a piece of text.
struct TextFault {
    std::size_t offset = 0;
    std::string what;
};

/// The first byte that is no part of valid UTF-8, or that is zero.
std::optional<TextFault> encoding_fault(std::string_view text);

/// What is wrong with the string whose opening quote begins `text`.
std::optional<TextFault> string_fault(std::string_view text);

}  // namespace hyrax
