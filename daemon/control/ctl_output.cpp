// SPDX-License-Identifier: MIT
#include "daemon/control/ctl_output.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hyrax {
namespace {

using json = nlohmann::ordered_json;

std::string number_text(double value) {
    return value == std::floor(value) && std::abs(value) < 1e15 ? fmt::format("{:.0f}", value)
                                                                : fmt::format("{}", value);
}

bool is_list_of_texts(const json& value) {
    return value.is_array() &&
           std::ranges::all_of(value, [](const json& item) { return item.is_string(); });
}

std::string cell(const json& value) {
    if (value.is_string()) {
        return value.get<std::string>();
    }
    if (value.is_number()) {
        return number_text(value.get<double>());
    }
    if (value.is_boolean()) {
        return value.get<bool>() ? "yes" : "no";
    }
    if (is_list_of_texts(value)) {
        return fmt::format("{}", fmt::join(value.get<std::vector<std::string>>(), " "));
    }
    return value.dump();
}

// Characters, not bytes: names may hold any of UTF-8.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80;
    }));
}

struct Row {
    std::vector<std::string> cells;
};

// Columns as wide as their widest cell; those of numbers stand to the right.
std::string aligned(const std::vector<Row>& rows, const std::vector<bool>& to_the_right) {
    std::vector<std::size_t> widths(to_the_right.size());
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            widths[i] = std::max(widths[i], width_of(row.cells[i]));
        }
    }
    std::string text;
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            const std::string gap(widths[i] - width_of(row.cells[i]), ' ');
            line += i > 0 ? "  " : "";
            line += to_the_right[i] ? gap + row.cells[i] : row.cells[i] + gap;
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

json member(const json& object, const std::string& name) {
    return object.value(name, json(""));
}

// A list of objects; the first one's names are the columns.
std::string table_of(const json& list) {
    std::vector<Row> rows(1);
    std::vector<bool> to_the_right;
    for (const auto& entry : list.front().items()) {
        const std::string& name = entry.key();
        rows.front().cells.push_back(name);
        to_the_right.push_back(std::ranges::all_of(list, [&name](const json& item) {
            return member(item, name).is_number();
        }));
    }
    for (const json& item : list) {
        Row row;
        for (const std::string& name : rows.front().cells) {
            row.cells.push_back(cell(member(item, name)));
        }
        rows.push_back(std::move(row));
    }
    return aligned(rows, to_the_right);
}

bool is_text(const json& object, const char* name) {
    return object.contains(name) && object[name].is_string();
}

bool is_table(const json& value) {
    return value.is_array() && !value.empty() &&
           std::ranges::all_of(value, [](const json& item) { return item.is_object(); });
}

// What a script answers is shown as it is.
std::string script_text(const json& result) {
    const auto value = result["value"].get<std::string>();
    return result["printed"].get<std::string>() + value + (value.empty() ? "" : "\n");
}

std::string text_of(const json& result) {
    if (is_text(result, "printed") && is_text(result, "value")) {
        return script_text(result);
    }
    std::string tables;
    std::vector<Row> lines;
    for (const auto& [name, value] : result.items()) {
        if (is_table(value)) {
            tables += table_of(value);
        } else if (value != "" && !(value.is_array() && value.empty())) {
            lines.push_back({{name, cell(value)}});
        }
    }
    return tables + aligned(lines, {false, false});
}

}  // namespace

ShownAnswer shown_answer(std::string_view text) {
    const json answer = json::parse(text, nullptr, false);
    const json ok = answer.is_object() ? answer.value("ok", json()) : json();
    if (ok == true && answer.contains("result")) {
        return {text_of(answer["result"]), ""};
    }
    if (ok == false && answer.contains("error") && answer["error"].is_object()) {
        const json& error = answer["error"];
        return {
            error.value("message", std::string("refused")), error.value("code", std::string("?"))
        };
    }
    return {"what answers does not speak as hyrax does", "?"};
}

std::string shown_event(std::string_view text) {
    const json event = json::parse(text, nullptr, false);
    if (!event.is_object()) {
        return std::string(text) + "\n";
    }
    std::string line = fmt::format(
        "{:>10.3f}  {:8}", event.value("seconds", 0.0), event.value("event", std::string())
    );
    for (const auto& [name, value] : event.items()) {
        if (name != "seconds" && name != "event") {
            line += fmt::format("  {}={}", name, cell(value));
        }
    }
    return line + "\n";
}

}  // namespace hyrax
