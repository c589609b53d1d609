// SPDX-License-Identifier: MIT
#include "daemon/core/located_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace hyrax {
namespace {

using nlohmann::json;

// What is legal at the cursor, after blanks.
enum class Expect { value, first_item, first_key, colon, comma_in_array, comma_in_object, end };

// A mark alone; else up to the next blank, mark or quote.
std::string word_at(std::string_view text) {
    constexpr std::string_view marks = ",:[]{}";
    constexpr std::size_t longest = 30;
    if (!text.empty() && marks.contains(text[0])) {
        return std::string(1, text[0]);
    }
    return shortened(text.substr(0, text.find_first_of(" \t\r\n,:[]{}\"/", 1)), longest);
}

std::string what_stands_at(const TextCursor& cursor) {
    return cursor.at_end() ? "the end of the file" : word_at(cursor.rest());
}

bool looks_like_number(char c) {
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

// Why no value begins at the cursor.
std::string value_fault(const TextCursor& cursor, bool overflow) {
    const char c = cursor.peek();
    if (overflow) {
        return fmt::format("the number {} is too large", word_at(cursor.rest()));
    }
    if (looks_like_number(c)) {
        return fmt::format(
            "{} is no number that JSON knows (such as 12, -0.5 or 1e3)", word_at(cursor.rest())
        );
    }
    std::string text = fmt::format("expected a value, found {}", what_stands_at(cursor));
    if (!cursor.at_end() && !std::string_view(",:]}").contains(c)) {
        text += "; a text needs double quotes";
    }
    return text;
}

// Finds out in plain words what a parser disliked behind the last good token.
class Diagnosis {
public:
    Diagnosis(TextCursor cursor, Expect expect, bool overflow)
        : cursor_(cursor), expect_(expect), overflow_(overflow) {}

    std::string run(std::string_view file) {
        cursor_.skip_blanks();
        std::string what = explain();
        if (cursor_.rest().starts_with("/*")) {
            what = "this comment is not closed: */ is missing";
        }
        return fmt::format("{}: {}", place_in_file(file, cursor_.position()), what);
    }

private:
    bool take(char mark) {
        if (cursor_.peek() != mark) {
            return false;
        }
        cursor_.advance(1);
        cursor_.skip_blanks();
        return true;
    }

    std::string expected(std::string_view what) const {
        return fmt::format("expected {}, found {}", what, what_stands_at(cursor_));
    }

    std::string string_text() {
        const std::optional<TextFault> fault = string_fault(cursor_.rest());
        cursor_.advance(fault ? fault->offset : 0);
        return fault ? fault->what : "a \\u escape in this text names no character";
    }

    std::string value() {
        return cursor_.peek() == '"' ? string_text() : value_fault(cursor_, overflow_);
    }

    std::string key(bool after_comma) {
        if (cursor_.peek() == '"') {
            return string_text();
        }
        if (after_comma && cursor_.peek() == '}') {
            return "a comma before } is not allowed";
        }
        return expected(after_comma ? "a key in double quotes" : "a key in double quotes or }");
    }

    std::string explain() {
        switch (expect_) {
            case Expect::value:
            case Expect::first_item:
                return value();
            case Expect::first_key:
                return key(false);
            case Expect::colon:
                return take(':') ? value() : expected("a : between key and value");
            case Expect::comma_in_array:
                if (!take(',')) {
                    return expected("a comma or ]");
                }
                return cursor_.peek() == ']' ? "a comma before ] is not allowed" : value();
            case Expect::comma_in_object:
                return take(',') ? key(true) : expected("a comma or }");
            case Expect::end:
                break;
        }
        return expected("the end of the file");
    }

    TextCursor cursor_;
    Expect expect_;
    bool overflow_;
};

// Receives nlohmann's events and follows them in the text. An event comes as soon as its token has
// been read, so that the cursor never has to look further than one token.
class Builder {
public:
    using number_integer_t = json::number_integer_t;
    using number_unsigned_t = json::number_unsigned_t;
    using number_float_t = json::number_float_t;
    using string_t = json::string_t;
    using binary_t = json::binary_t;

    Builder(std::string_view text, std::string_view file) : cursor_(text), file_(file) {}

    LocatedJson take_root() { return std::move(root_); }
    const std::string& fault() const { return fault_; }

    // The names and signatures below are nlohmann's SAX interface.
    bool null() { return scalar(nullptr); }
    bool boolean(bool value) { return scalar(value); }
    bool number_integer(number_integer_t value) { return scalar(value); }
    bool number_unsigned(number_unsigned_t value) { return scalar(value); }
    bool number_float(number_float_t value, const string_t&) { return scalar(value); }
    bool string(string_t& value) { return scalar(std::move(value)); }
    bool binary(binary_t&) { return false; }  // not part of JSON text
    bool start_object(std::size_t) { return open(json::object()); }
    bool start_array(std::size_t) { return open(json::array()); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    bool key(string_t& name) {
        cursor_.skip_to_token();
        key_at_ = cursor_.position();
        cursor_.take_string();
        const auto [former, is_new] = open_.back().keys.emplace(name, key_at_);
        if (!is_new) {
            fault_ = fmt::format(
                "{}: the key \"{}\" is already in this object, in line {}",
                place_in_file(file_, key_at_),
                shortened(name, 60),
                former->second.line
            );
            return false;
        }
        key_ = std::move(name);
        expect_ = Expect::colon;
        return true;
    }

    bool parse_error(std::size_t, const std::string&, const json::exception& exception) {
        constexpr int number_overflow = 406;  // nlohmann's number for out_of_range of a literal
        fault_ = Diagnosis(cursor_, expect_, exception.id == number_overflow).run(file_);
        return false;
    }

private:
    struct Level {
        LocatedJson container;
        std::map<std::string, TextPosition> keys;
    };

    LocatedJson begin(json value) {
        cursor_.skip_to_token();
        LocatedJson begun;
        begun.at = cursor_.position();
        const bool member = !open_.empty() && open_.back().container.value.is_object();
        begun.key_at = member ? key_at_ : begun.at;
        begun.key = std::exchange(key_, {});
        begun.value = std::move(value);
        return begun;
    }

    bool scalar(json value) {
        LocatedJson leaf = begin(std::move(value));
        leaf.source = leaf.value.is_string() ? cursor_.take_string() : cursor_.take_scalar();
        finish(std::move(leaf));
        return true;
    }

    bool open(json empty) {
        const bool object = empty.is_object();
        LocatedJson container = begin(std::move(empty));
        container.source = cursor_.rest();
        if (open_.size() == max_json_depth) {
            fault_ = fmt::format(
                "{}: nested more than {} deep", place_in_file(file_, container.at), max_json_depth
            );
            return false;
        }
        cursor_.advance(1);
        open_.push_back({std::move(container), {}});
        expect_ = object ? Expect::first_key : Expect::first_item;
        return true;
    }

    bool close() {
        cursor_.skip_to_token();
        cursor_.advance(1);
        LocatedJson container = std::move(open_.back().container);
        open_.pop_back();
        container.source.remove_suffix(cursor_.rest().size());
        finish(std::move(container));
        return true;
    }

    void finish(LocatedJson value) {
        if (open_.empty()) {
            root_ = std::move(value);
            expect_ = Expect::end;
            return;
        }
        LocatedJson& parent = open_.back().container;
        expect_ = parent.value.is_object() ? Expect::comma_in_object : Expect::comma_in_array;
        parent.children.push_back(std::move(value));
    }

    TextCursor cursor_;
    std::string_view file_;
    Expect expect_ = Expect::value;
    LocatedJson root_;
    std::vector<Level> open_;
    std::string key_;
    TextPosition key_at_;
    std::string fault_;
};

}  // namespace

std::string place_in_file(std::string_view file, TextPosition at) {
    return fmt::format("{}:{}:{}", file, at.line, at.column);
}

const LocatedJson* LocatedJson::member(std::string_view name) const {
    const auto found = std::ranges::find(children, name, &LocatedJson::key);
    return value.is_object() && found != children.end() ? &*found : nullptr;
}

Result<LocatedJson> parse_located_json(std::string_view text, std::string_view file) {
    constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";
    if (text.starts_with(utf8_mark)) {
        text.remove_prefix(utf8_mark.size());
    }
    TextCursor cursor(text);
    if (const std::optional<TextFault> fault = encoding_fault(text)) {
        cursor.advance(fault->offset);
        return failure(fmt::format("{}: {}", place_in_file(file, cursor.position()), fault->what));
    }
    cursor.skip_blanks();
    if (cursor.at_end()) {
        return failure(fmt::format("{}: the file is empty; at least {{}} is needed", file));
    }
    Builder builder(text, file);
    constexpr bool whole_text = true;
    constexpr bool allow_comments = true;
    try {
        if (!json::sax_parse(
                text, &builder, json::input_format_t::json, whole_text, allow_comments
            )) {
            return failure(builder.fault());
        }
    } catch (const json::exception& exception) {
        return failure(fmt::format("{}: {}", file, exception.what()));
    }
    return builder.take_root();
}

}  // namespace hyrax
