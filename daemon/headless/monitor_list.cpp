// SPDX-License-Identifier: MIT
#include "daemon/headless/monitor_list.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <optional>

namespace hyrax {
namespace {

constexpr int max_side = 32768;
constexpr int max_corner = 100'000;

// Takes a number off the front of the text; a '+' may stand before it where a sign is allowed.
std::optional<int> take_number(std::string_view& text, bool is_signed) {
    if (is_signed) {
        if (text.empty() || (text.front() != '+' && text.front() != '-')) {
            return std::nullopt;
        }
        if (text.front() == '+') {
            text.remove_prefix(1);
        }
    }
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || (!is_signed && number < 0)) {
        return std::nullopt;
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

std::optional<Rect> parse_rect(std::string_view text) {
    const std::optional<int> width = take_number(text, false);
    if (!width || text.empty() || text.front() != 'x') {
        return std::nullopt;
    }
    text.remove_prefix(1);
    const std::optional<int> height = take_number(text, false);
    const std::optional<int> x = take_number(text, true);
    const std::optional<int> y = take_number(text, true);
    if (!height || !x || !y || !text.empty()) {
        return std::nullopt;
    }
    const bool in_range = *width >= 1 && *width <= max_side && *height >= 1 &&
                          *height <= max_side && std::abs(*x) <= max_corner &&
                          std::abs(*y) <= max_corner;
    return in_range ? std::optional(Rect{*x, *y, *width, *height}) : std::nullopt;
}

// Takes "@1.5" off the end of the text.
std::optional<double> take_scale(std::string_view& text) {
    const std::size_t at = text.find('@');
    if (at == std::string_view::npos) {
        return 1.0;
    }
    const std::string_view number = text.substr(at + 1);
    text = text.substr(0, at);
    double scale = 0.0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), scale);
    const bool whole = error == std::errc() && end == number.data() + number.size();
    return whole && scale >= 0.5 && scale <= 5.0 ? std::optional(scale) : std::nullopt;
}

}  // namespace

Result<std::vector<Monitor>> parse_monitors(std::string_view text) {
    std::vector<Monitor> monitors;
    while (!text.empty()) {
        std::string_view one = text.substr(0, text.find(','));
        const std::string_view given = one;
        text.remove_prefix(std::min(one.size() + 1, text.size()));
        const std::optional<double> scale = take_scale(one);
        const std::optional<Rect> rect = parse_rect(one);
        if (!rect || !scale) {
            return failure(fmt::format(
                "--monitors: expected WIDTHxHEIGHT+X+Y (such as 1920x1080+0+0) or "
                "WIDTHxHEIGHT+X+Y@SCALE, got \"{}\"",
                given
            ));
        }
        monitors.push_back({
            .bounds = *rect,
            .work = *rect,
            .primary = monitors.empty(),
            .name = fmt::format("monitor {}", monitors.size() + 1),
            .scale = *scale,
        });
    }
    return monitors;
}

}  // namespace hyrax
