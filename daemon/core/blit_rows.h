// SPDX-License-Identifier: MIT
// Rows of pixels over others: what the blitter's kernels have in common.
#pragma once

#include "daemon/core/image.h"

#include <cstddef>

namespace hyrax {

/// A rectangle of a picture, and the pixels it goes over.
struct Rows {
    Pixel* to = nullptr;
    std::ptrdiff_t to_stride = 0;  ///< Pixels from one row to the next.
    const Pixel* from = nullptr;
    std::ptrdiff_t from_stride = 0;
    int width = 0;  ///< Pixels in a row.
    int count = 0;  ///< Rows that are left.

    /// One row further down.
    void next() {
        to += to_stride;
        from += from_stride;
        --count;
    }
};

/// Source-over. All kernels give the same bits for any pixels that are premultiplied.
using Blend = void (*)(Rows rows);
/// The same, with the source first faded to opacity / 255; 1 to 254.
using FadedBlend = void (*)(Rows rows, unsigned opacity);

void blend_scalar(Rows rows);
void blend_sse2(Rows rows);
void blend_avx2(Rows rows);

void blend_faded_scalar(Rows rows, unsigned opacity);
void blend_faded_sse2(Rows rows, unsigned opacity);
void blend_faded_avx2(Rows rows, unsigned opacity);

}  // namespace hyrax
