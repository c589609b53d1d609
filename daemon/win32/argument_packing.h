// SPDX-License-Identifier: MIT
// The arguments of a second start as one block of bytes, for the first one. Pure.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hyrax::win32 {

/// Far more than a command line can hold.
inline constexpr std::size_t max_packed_arguments = 64U << 10U;

/// Each argument with a zero byte behind it. None if they are too long; zero bytes within an
/// argument cannot come from a command line.
inline std::optional<std::string> pack_arguments(std::span<const std::string> arguments) {
    std::string packed;
    for (const std::string& argument : arguments) {
        packed += argument;
        packed += '\0';
    }
    return packed.size() <= max_packed_arguments ? std::optional(packed) : std::nullopt;
}

/// None if the block was not made by pack_arguments: it comes from another process.
inline std::optional<std::vector<std::string>> unpack_arguments(std::span<const char> packed) {
    if (packed.size() > max_packed_arguments || (!packed.empty() && packed.back() != '\0')) {
        return std::nullopt;
    }
    std::vector<std::string> arguments;
    std::string argument;
    for (const char byte : packed) {
        if (byte == '\0') {
            arguments.push_back(std::move(argument));
            argument.clear();
        } else {
            argument += byte;
        }
    }
    return arguments;
}

}  // namespace hyrax::win32
