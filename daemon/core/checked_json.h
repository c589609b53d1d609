// SPDX-License-Identifier: MIT
// Typed reading of located JSON: every value that is not as it should be leaves one line that says
// where it is, what was expected and what was found. Only for the *_json.cpp files.
#pragma once

#include "daemon/core/located_json.h"
#include "daemon/core/result.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hyrax {

/// The errors and warnings of one file, in the order of their discovery.
class JsonProblems {
public:
    /// More lines than this are counted, not kept.
    static constexpr std::size_t most_lines = 20;

    explicit JsonProblems(std::string file) : file_(std::move(file)) {}

    /// Appends "file:line:column: pointer: text".
    void error(TextPosition at, std::string_view pointer, std::string_view text);
    void warning(TextPosition at, std::string_view pointer, std::string_view text);

    bool has_errors() const { return errors_.total != 0; }
    /// Whether a further warning's text would be kept.
    bool keeps_warnings() const { return warnings_.kept.size() < most_lines; }
    /// All errors, a line each.
    Error error() const;
    std::vector<std::string> warnings() const { return warnings_.shown(); }
    const std::string& file() const { return file_; }

private:
    struct Lines {
        std::vector<std::string> kept;
        std::size_t total = 0;

        std::vector<std::string> shown() const;
    };

    void add(Lines& lines, TextPosition at, std::string_view pointer, std::string_view text) const;

    std::string file_;
    Lines errors_;
    Lines warnings_;
};

/// A value on the way from the root, with its JSON pointer. Views into the tree and the problems.
/// The readers return nothing, and have told the problems, where the value is not as asked for.
class JsonValue {
public:
    JsonValue(const LocatedJson& located, std::string pointer, JsonProblems& problems)
        : json_(&located), pointer_(std::move(pointer)), problems_(&problems) {}

    const LocatedJson& located() const { return *json_; }
    const std::string& pointer() const { return pointer_; }
    /// "config.json:12:18"
    std::string place() const;
    /// What is there, for messages: a scalar as the file writes it.
    std::string found() const;

    std::optional<double> number(double low, double high) const;
    /// 3.0 and 3e0 are whole as well.
    std::optional<int> whole_number(int low, int high) const;
    std::optional<bool> flag() const;
    /// The name of a file or folder: 1 to 100 bytes, none of / \ : * ? " < > | and no control
    /// character, neither "." nor "..".
    std::optional<std::string> name() const;
    /// Such names joined by /, so that nothing outside a folder can be meant.
    std::optional<std::string> relative_path() const;
    /// The same, where * and ? are allowed.
    std::optional<std::string> path_pattern() const;
    std::optional<std::string> choice(std::span<const std::string_view> choices) const;

    /// False, with an error, for anything but an object.
    bool is_object() const;
    /// The member, or nothing without an error.
    std::optional<JsonValue> member(std::string_view name) const;
    /// The member, or nothing with an error at this object.
    std::optional<JsonValue> required(std::string_view name) const;
    /// An object's members or an array's items.
    std::vector<JsonValue> children() const;
    /// An array's items; nothing, with an error, for anything else and for a wrong number of them.
    std::optional<std::vector<JsonValue>> items(std::size_t low, std::size_t high) const;

    void error(std::string_view text) const;
    /// error("<expected>, got <what is there>")
    void expected(std::string_view what) const;
    void error_at_key(std::string_view text) const;
    /// Warns of this key, which is none of the known ones, and names the nearest of them.
    void warn_of_unknown_key(std::span<const std::string_view> known) const;
    /// The same as an error, but only where one of the known names is near.
    void refuse_misspelt_key(std::span<const std::string_view> known) const;

private:
    JsonValue child(const LocatedJson& located, std::string_view step) const;
    std::optional<std::string> text_if(bool (*fits)(std::string_view), std::string_view what) const;

    const LocatedJson* json_;
    std::string pointer_;
    JsonProblems* problems_;
};

}  // namespace hyrax
