// SPDX-License-Identifier: MIT
#include "daemon/core/checked_json.h"
#include "daemon/core/files.h"
#include "daemon/core/remembered.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <system_error>

namespace hyrax {
namespace {

using nlohmann::json;

constexpr std::size_t most_bytes = std::size_t{1} << 20U;
constexpr std::size_t most_entries = 1000;
// Whole numbers up to here are exact as doubles.
constexpr double latest = 9e15;

void read_flag(const JsonValue& root, const char* key, auto& slot) {
    if (const std::optional<JsonValue> value = root.member(key)) {
        if (const std::optional<bool> flag = value->flag()) {
            slot = *flag;
        }
    }
}

void read_flags(const JsonValue& value, std::map<std::string, bool>& flags) {
    if (!value.is_object()) {
        return;
    }
    for (const JsonValue& each : value.children()) {
        if (const std::optional<bool> allowed = each.flag()) {
            flags[each.located().key] = *allowed;
        }
    }
}

void read_granted(
    const JsonValue& value, std::map<std::string, std::vector<std::string>>& granted
) {
    if (!value.is_object()) {
        return;
    }
    for (const JsonValue& each : value.children()) {
        std::vector<std::string>& list = granted[each.located().key];
        for (const JsonValue& item :
             each.items(0, most_entries).value_or(std::vector<JsonValue>{})) {
            if (std::optional<std::string> name = item.name()) {
                list.push_back(*std::move(name));
            }
        }
    }
}

void read_scripts(const JsonValue& value, std::set<std::string>& scripts) {
    for (const JsonValue& each : value.items(0, most_entries).value_or(std::vector<JsonValue>{})) {
        if (const std::optional<std::string> name = each.relative_path()) {
            scripts.insert(*name);
        }
    }
}

}  // namespace

Result<Remembered> parse_remembered(std::string_view text, std::string_view file) {
    const Result<LocatedJson> located = parse_located_json(text, file);
    if (!located) {
        return std::unexpected(located.error());
    }
    JsonProblems problems{std::string(file)};
    const JsonValue root(*located, "", problems);
    Remembered result;
    if (root.is_object()) {
        read_flag(root, "hidden", result.hidden);
        if (const auto value = root.member("hidden_until")) {
            if (const std::optional<double> until = value->number(0.0, latest)) {
                result.hidden_until = std::llround(*until);
            }
        }
        read_flag(root, "quiet", result.quiet);
        read_flag(root, "click_through", result.click_through);
        if (const auto value = root.member("monitors")) {
            read_flags(*value, result.monitors);
        }
        if (const auto value = root.member("scripts_off")) {
            read_scripts(*value, result.scripts_off);
        }
        if (const auto value = root.member("plugins")) {
            read_flags(*value, result.plugins);
        }
        if (const auto value = root.member("granted")) {
            read_granted(*value, result.granted);
        }
        read_flag(root, "greeted", result.greeted);
    }
    if (problems.has_errors()) {
        return std::unexpected(problems.error());
    }
    return result;
}

std::string text_of(const Remembered& remembered) {
    json root = json::object();
    root["hidden"] = remembered.hidden;
    if (remembered.hidden_until) {
        root["hidden_until"] = *remembered.hidden_until;
    }
    if (remembered.quiet) {
        root["quiet"] = *remembered.quiet;
    }
    if (remembered.click_through) {
        root["click_through"] = *remembered.click_through;
    }
    root["monitors"] = remembered.monitors;
    root["scripts_off"] = remembered.scripts_off;
    root["plugins"] = remembered.plugins;
    root["granted"] = remembered.granted;
    root["greeted"] = remembered.greeted;
    return root.dump(4, ' ', false, json::error_handler_t::replace) + "\n";
}

Result<Remembered> load_remembered(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error) && !error) {
        return Remembered{};
    }
    const Result<std::string> text = read_text_file(file, most_bytes);
    if (!text) {
        return std::unexpected(text.error());
    }
    return parse_remembered(*text, utf8_from_path(file));
}

Result<void> save_remembered(const std::filesystem::path& file, const Remembered& remembered) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) {
        return failure(fmt::format(
            "{}: cannot be made: {}", utf8_from_path(file.parent_path()), error.message()
        ));
    }
    return write_file_atomically(file, text_of(remembered));
}

}  // namespace hyrax
