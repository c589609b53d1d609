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

void blend_scalar(Pixel* to, const Pixel* from, int count) {
    for (int i = 0; i < count; ++i) {
        if (alpha_of(from[i]) == 255) {
            to[i] = from[i];
        } else if (from[i] != 0) {
            to[i] = source_over(from[i], to[i]);
        }
    }
}

void blend_faded_scalar(Pixel* to, const Pixel* from, int count, unsigned opacity) {
    for (int i = 0; i < count; ++i) {
        if (from[i] != 0) {
            to[i] = source_over(times(from[i], opacity), to[i]);
        }
    }
}

}  // namespace hyrax
