// SPDX-License-Identifier: MIT
// Expected failures: values with a message for the person who reads it at midnight.
#pragma once

#include <expected>
#include <string>
#include <utility>

namespace hyrax {

/// The message says what failed, on what, and why:
/// `config.json:12:18: /physics/restitution: must be a number from 0 to 1, got 1.5`.
struct Error {
    std::string message;
};

template <typename T>
using Result = std::expected<T, Error>;

/// `return failure("...")` from a function that returns a Result.
inline std::unexpected<Error> failure(std::string message) {
    return std::unexpected(Error{std::move(message)});
}

}  // namespace hyrax
