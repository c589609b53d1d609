// SPDX-License-Identifier: MIT
// The reference: one pixel at a time.
#include "daemon/core/blit_rows.h"

namespace hyrax {
namespace {

// All channels times factor / 255, rounded to nearest: (v + 128 + ((v + 128) >> 8)) >> 8 equals
// round(v / 255) for v up to 255 * 255. Two channels at a time, in the low bytes of 16-bit lanes.
Pixel times(Pixel pixel, std::uint32_t factor) {
    constexpr std::uint32_t low_bytes = 0x00FF00FFU;
    const auto pair = [factor](std::uint32_t channels) {
        const std::uint32_t v = channels * factor + 0x00800080U;
        return ((v + ((v >> 8U) & low_bytes)) >> 8U) & low_bytes;
    };
    return pair(pixel & low_bytes) | pair((pixel >> 8U) & low_bytes) << 8U;
}

Pixel source_over(Pixel source, Pixel target) {
    return source + times(target, 255U - alpha_of(source));
}

}  // namespace

void blend_scalar(Rows rows) {
    for (; rows.count > 0; rows.next()) {
        for (int i = 0; i < rows.width; ++i) {
            if (alpha_of(rows.from[i]) == 255) {
                rows.to[i] = rows.from[i];
            } else if (rows.from[i] != 0) {
                rows.to[i] = source_over(rows.from[i], rows.to[i]);
            }
        }
    }
}

void blend_faded_scalar(Rows rows, unsigned opacity) {
    for (; rows.count > 0; rows.next()) {
        for (int i = 0; i < rows.width; ++i) {
            if (rows.from[i] != 0) {
                rows.to[i] = source_over(times(rows.from[i], opacity), rows.to[i]);
            }
        }
    }
}

}  // namespace hyrax
