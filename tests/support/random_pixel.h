// SPDX-License-Identifier: MIT
// Pixels by chance, the same on every machine.
#pragma once

#include "daemon/core/image.h"

#include <cstdint>
#include <random>

namespace hyrax {

/// From 0 to `most`.
inline unsigned random_up_to(unsigned most, std::minstd_rand& random) {
    // The low bits of the generator are the worst.
    return static_cast<unsigned>((std::uint64_t{random()} >> 8U) % (most + 1));
}

inline Pixel random_pixel(std::minstd_rand& random, unsigned alpha) {
    Pixel pixel = alpha << 24U;
    for (const unsigned shift : {16U, 8U, 0U}) {
        pixel |= random_up_to(alpha, random) << shift;
    }
    return pixel;
}

inline Pixel random_pixel(std::minstd_rand& random) {
    return random_pixel(random, random_up_to(255, random));
}

}  // namespace hyrax
