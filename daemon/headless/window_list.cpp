// SPDX-License-Identifier: MIT
#include "daemon/headless/window_list.h"

#include "daemon/core/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace hyrax {
namespace {

constexpr double most_seconds = 1e6;
constexpr int most_px = 1'000'000;
constexpr std::size_t most_bytes = std::size_t{16} << 20;

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Takes the part before the next separator off the front of the text.
std::string_view take(std::string_view& text, char separator) {
    const std::string_view part = text.substr(0, text.find(separator));
    text.remove_prefix(std::min(part.size() + 1, text.size()));
    return trimmed(part);
}

template <typename Number>
std::optional<Number> number(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole ? std::optional(value) : std::nullopt;
}

std::optional<Ticks> time_of(std::string_view text) {
    const std::optional<double> seconds = number<double>(text);
    if (!seconds || !(*seconds >= 0.0 && *seconds <= most_seconds)) {
        return std::nullopt;
    }
    return from_seconds(*seconds);
}

bool mark(DesktopWindow& window, std::string_view word) {
    if (word == "active") {
        window.active = true;
    } else if (word == "hidden") {
        window.visible = false;
    } else if (word == "overlay") {
        window.solid = false;
    } else if (word == "bar") {
        window.has_caption = false;
    } else if (word == "maximised") {
        window.maximised = true;
    } else {
        return false;
    }
    return true;
}

Result<DesktopWindow> window_of(std::string_view line) {
    DesktopWindow window;
    const std::string_view id = take(line, ',');
    const std::optional<std::uint64_t> name = number<std::uint64_t>(id);
    if (!name) {
        return failure(fmt::format("the window's id must be a whole number, got \"{}\"", id));
    }
    window.id = *name;
    for (int* const part :
         {&window.bounds.x, &window.bounds.y, &window.bounds.width, &window.bounds.height}) {
        const std::string_view text = take(line, ',');
        const std::optional<int> px = number<int>(text);
        const bool is_side = part == &window.bounds.width || part == &window.bounds.height;
        if (!px || *px > most_px || *px < (is_side ? 0 : -most_px)) {
            return failure(fmt::format(
                "expected time,id,x,y,width,height with whole numbers of pixels, got \"{}\"", text
            ));
        }
        *part = *px;
    }
    while (!line.empty()) {
        const std::string_view word = take(line, ' ');
        if (!word.empty() && !mark(window, word)) {
            return failure(fmt::format(
                "expected the words active, hidden, overlay, bar or maximised, got \"{}\"", word
            ));
        }
    }
    return window;
}

Result<void> add_line(std::vector<TimedWindows>& all, std::string_view line) {
    const std::string_view text = take(line, ',');
    const std::optional<Ticks> time = time_of(text);
    if (!time) {
        return failure(
            fmt::format("the time must be seconds from 0 to {}, got \"{}\"", most_seconds, text)
        );
    }
    if (!all.empty() && *time < all.back().time) {
        return failure(
            fmt::format("times may not go back: {} after {}", text, to_seconds(all.back().time))
        );
    }
    if (all.empty() || *time > all.back().time) {
        all.push_back({*time, {}});
    }
    if (line.empty()) {
        return {};
    }
    Result<DesktopWindow> window = window_of(line);
    if (!window) {
        return std::unexpected(window.error());
    }
    all.back().windows.push_back(*window);
    return {};
}

}  // namespace

Result<std::vector<TimedWindows>> parse_windows(std::string_view text, std::string_view file) {
    std::vector<TimedWindows> all;
    for (int line_number = 1; !text.empty(); ++line_number) {
        const std::string_view line = take(text, '\n');
        if (line.empty() || line.starts_with('#')) {
            continue;
        }
        if (const Result<void> added = add_line(all, line); !added) {
            return failure(fmt::format("{}:{}: {}", file, line_number, added.error().message));
        }
    }
    return all;
}

Result<std::vector<TimedWindows>> load_windows(const std::filesystem::path& path) {
    const Result<std::string> text = read_text_file(path, most_bytes);
    if (!text) {
        return std::unexpected(text.error());
    }
    return parse_windows(*text, utf8_from_path(path.filename()));
}

}  // namespace hyrax
