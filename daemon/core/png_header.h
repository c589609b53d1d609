// SPDX-License-Identifier: MIT
// The size that a PNG file claims, from its first bytes. Pure.
#pragma once

#include "physics/geometry.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace hyrax {

/// As many bytes of a file as png_size() looks at.
inline constexpr std::size_t png_header_bytes = 24;

/// None if it does not begin as a PNG file does. Sides above 2^31 come out as the largest int.
inline std::optional<Size> png_size(std::span<const std::byte> file) {
    constexpr std::array<unsigned, 16> start{
        0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A, 0, 0, 0, 13, 'I', 'H', 'D', 'R'
    };
    if (file.size() < png_header_bytes) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < start.size(); ++i) {
        if (std::to_integer<unsigned>(file[i]) != start[i]) {
            return std::nullopt;
        }
    }
    const auto side = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = at; i < at + 4; ++i) {
            value = (value << 8U) | std::to_integer<std::uint32_t>(file[i]);
        }
        return static_cast<int>(value & 0x7FFFFFFFU) | (value > 0x7FFFFFFFU ? 0x7FFFFFFF : 0);
    };
    return Size{side(16), side(20)};
}

}  // namespace hyrax
