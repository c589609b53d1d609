// SPDX-License-Identifier: MIT
#include "daemon/core/checked_json.h"

#include "daemon/core/nearest_name.h"
#include "daemon/core/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyrax {
namespace {

using nlohmann::json;

// Bounds as a person writes them: 1000000000, not 1e+09.
std::string bound(double value) {
    return value == std::floor(value) ? fmt::format("{:.0f}", value) : fmt::format("{}", value);
}

std::string what_is_there(const LocatedJson& found) {
    constexpr std::size_t longest = 40;
    if (found.value.is_object()) {
        return "an object { }";
    }
    return found.value.is_array() ? "a list [ ]" : shortened(found.source, longest);
}

// RFC 6901, except for control characters, which would break a message.
std::string pointer_step(std::string_view key) {
    constexpr std::size_t longest = 60;
    std::string step;
    for (const char c : shortened(key, longest)) {
        if (c == '~' || c == '/') {
            step += c == '~' ? "~0" : "~1";
        } else {
            step += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
        }
    }
    return step;
}

std::string quoted_list(std::span<const std::string_view> names) {
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string_view separator = i == 0 ? "" : i + 1 == names.size() ? " or " : ", ";
        list += fmt::format("{}\"{}\"", separator, names[i]);
    }
    return list;
}

std::string did_you_mean(std::string_view unknown, std::span<const std::string_view> known) {
    const std::optional<std::string_view> nearest = nearest_name(unknown, known);
    return nearest ? fmt::format("; did you mean \"{}\"?", *nearest) : std::string();
}

bool is_name_with(std::string_view text, std::string_view forbidden) {
    constexpr std::size_t longest = 100;
    const auto allowed = [&](char c) {
        return static_cast<unsigned char>(c) >= 0x20 && !forbidden.contains(c);
    };
    return !text.empty() && text.size() <= longest && text != "." && text != ".." &&
           std::ranges::all_of(text, allowed);
}

bool is_name(std::string_view text) {
    return is_name_with(text, "/\\:*?\"<>|");
}

bool is_path_of(std::string_view text, bool (*fits)(std::string_view)) {
    while (true) {
        const std::size_t slash = text.find('/');
        if (!fits(text.substr(0, slash))) {
            return false;
        }
        if (slash == std::string_view::npos) {
            return true;
        }
        text.remove_prefix(slash + 1);
    }
}

bool is_relative_path(std::string_view text) {
    return is_path_of(text, is_name);
}

bool is_path_pattern(std::string_view text) {
    return is_path_of(text, [](std::string_view part) { return is_name_with(part, "/\\:\"<>|"); });
}

}  // namespace

std::vector<std::string> JsonProblems::Lines::shown() const {
    std::vector<std::string> lines = kept;
    if (total > kept.size()) {
        lines.push_back(fmt::format("... and {} more", total - kept.size()));
    }
    return lines;
}

void JsonProblems::add(
    Lines& lines, TextPosition at, std::string_view pointer, std::string_view text
) const {
    ++lines.total;
    if (lines.kept.size() == most_lines) {
        return;
    }
    const std::string_view separator = pointer.empty() ? "" : ": ";
    lines.kept.push_back(
        fmt::format("{}: {}{}{}", place_in_file(file_, at), pointer, separator, text)
    );
}

void JsonProblems::error(TextPosition at, std::string_view pointer, std::string_view text) {
    add(errors_, at, pointer, text);
}

void JsonProblems::warning(TextPosition at, std::string_view pointer, std::string_view text) {
    add(warnings_, at, pointer, text);
}

Error JsonProblems::error() const {
    return {fmt::format("{}", fmt::join(errors_.shown(), "\n"))};
}

std::optional<double> JsonValue::number(double low, double high) const {
    const json& value = json_->value;
    if (!value.is_number() || !(value.get<double>() >= low && value.get<double>() <= high)) {
        expected(fmt::format("must be a number from {} to {}", bound(low), bound(high)));
        return std::nullopt;
    }
    return value.get<double>();
}

std::optional<int> JsonValue::whole_number(int low, int high) const {
    const json& value = json_->value;
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (!(number >= low && number <= high) || number != std::floor(number)) {
        expected(fmt::format("must be a whole number from {} to {}", low, high));
        return std::nullopt;
    }
    return static_cast<int>(number);
}

std::optional<bool> JsonValue::flag() const {
    if (!json_->value.is_boolean()) {
        expected("must be true or false");
        return std::nullopt;
    }
    return json_->value.get<bool>();
}

std::optional<std::string> JsonValue::text_if(bool (*fits)(std::string_view), std::string_view what)
    const {
    const json& value = json_->value;
    if (!value.is_string() || !fits(value.get_ref<const std::string&>())) {
        expected(what);
        return std::nullopt;
    }
    return value.get<std::string>();
}

std::optional<std::string> JsonValue::name() const {
    return text_if(is_name, "must be a name of 1 to 100 characters without / \\ : * ? < > |");
}

std::optional<std::string> JsonValue::relative_path() const {
    return text_if(is_relative_path, "must be a file in this folder, such as \"sheet.png\"");
}

std::optional<std::string> JsonValue::path_pattern() const {
    return text_if(
        is_path_pattern, "must be a file name, * and ? allowed, with / between folders and no .."
    );
}

std::optional<std::string> JsonValue::choice(std::span<const std::string_view> choices) const {
    const json& value = json_->value;
    if (value.is_string() &&
        std::ranges::count(choices, value.get_ref<const std::string&>()) != 0) {
        return value.get<std::string>();
    }
    const std::string hint =
        value.is_string() ? did_you_mean(value.get_ref<const std::string&>(), choices) : "";
    error(fmt::format("must be {}, got {}{}", quoted_list(choices), what_is_there(*json_), hint));
    return std::nullopt;
}

bool JsonValue::is_object() const {
    if (!json_->value.is_object()) {
        expected("must be an object { }");
    }
    return json_->value.is_object();
}

std::optional<JsonValue> JsonValue::member(std::string_view name) const {
    const LocatedJson* found = json_->member(name);
    return found == nullptr ? std::nullopt : std::optional(child(*found, pointer_step(name)));
}

std::optional<JsonValue> JsonValue::required(std::string_view name) const {
    std::optional<JsonValue> found = member(name);
    if (!found) {
        error(fmt::format("\"{}\" is missing", name));
    }
    return found;
}

std::vector<JsonValue> JsonValue::children() const {
    std::vector<JsonValue> result;
    for (const LocatedJson& each : json_->children) {
        const bool member = json_->value.is_object();
        result.push_back(
            child(each, member ? pointer_step(each.key) : std::to_string(result.size()))
        );
    }
    return result;
}

std::optional<std::vector<JsonValue>> JsonValue::items(std::size_t low, std::size_t high) const {
    const std::size_t count = json_->children.size();
    if (!json_->value.is_array() || count < low || count > high) {
        const std::string what = fmt::format("must be a list [ ] of {} to {} items", low, high);
        if (json_->value.is_array()) {
            error(fmt::format("{}, got {}", what, count));
        } else {
            expected(what);
        }
        return std::nullopt;
    }
    return children();
}

std::string JsonValue::place() const {
    return place_in_file(problems_->file(), json_->at);
}

std::string JsonValue::found() const {
    return what_is_there(*json_);
}

void JsonValue::error(std::string_view text) const {
    problems_->error(json_->at, pointer_, text);
}

void JsonValue::expected(std::string_view what) const {
    error(fmt::format("{}, got {}", what, what_is_there(*json_)));
}

void JsonValue::error_at_key(std::string_view text) const {
    problems_->error(json_->key_at, pointer_, text);
}

void JsonValue::warn_of_unknown_key(std::span<const std::string_view> known) const {
    // A hostile file has a hundred thousand of them: no search for lines that nobody will see.
    const bool wanted = problems_->keeps_warnings();
    const std::string hint = wanted ? did_you_mean(json_->key, known) : std::string();
    problems_->warning(json_->key_at, pointer_, "unknown key" + hint);
}

void JsonValue::refuse_misspelt_key(std::span<const std::string_view> known) const {
    const std::string hint = did_you_mean(json_->key, known);
    if (!hint.empty()) {
        error_at_key("unknown key" + hint);
    }
}

JsonValue JsonValue::child(const LocatedJson& located, std::string_view step) const {
    return {located, fmt::format("{}/{}", pointer_, step), *problems_};
}

}  // namespace hyrax
