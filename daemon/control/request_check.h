// SPDX-License-Identifier: MIT
// From the text of a request to a verb and arguments that fit it. Both ends use it: hyraxctl before
// it sends, the daemon before it obeys.
#pragma once

#include "daemon/control/verb.h"

#include <nlohmann/json.hpp>

#include <expected>
#include <string>
#include <string_view>

namespace hyrax {

/// Deeper requests are refused.
inline constexpr std::size_t max_request_depth = 16;

struct CheckedRequest {
    const Verb* verb = nullptr;
    nlohmann::ordered_json
        arguments;  ///< An object with known names and values of the right type alone.
};

/// `{"do": "spawn", "count": 3}`. Refusals name the argument, what was expected and what was found:
/// `count: must be a whole number from 1 to 1000, got 0`.
std::expected<CheckedRequest, Refusal> check_request(std::string_view text);
std::expected<void, Refusal> check_arguments(
    const Verb& verb, const nlohmann::ordered_json& arguments
);

/// `there is no "spwan"; did you mean "spawn"?`
std::string unknown_name(std::string_view name, std::span<const std::string_view> known);

/// What a parameter takes: "a whole number from 1 to 1000".
std::string expectation(const Parameter& parameter);

/// A bound as a person writes it: 1000000, not 1e+06.
std::string plain_number(double value);

}  // namespace hyrax
