// SPDX-License-Identifier: MIT
// One row of pixels over another: what the blitter's kernels have in common.
#pragma once

#include "daemon/core/image.h"

namespace hyrax {

/// Source-over of `count` pixels. All kernels give the same bits for any pixels that are
/// premultiplied.
using RowBlend = void (*)(Pixel* to, const Pixel* from, int count);
/// The same, with the source first faded to opacity / 255; 1 to 254.
using FadedRowBlend = void (*)(Pixel* to, const Pixel* from, int count, unsigned opacity);

void blend_scalar(Pixel* to, const Pixel* from, int count);
void blend_sse2(Pixel* to, const Pixel* from, int count);
void blend_avx2(Pixel* to, const Pixel* from, int count);

void blend_faded_scalar(Pixel* to, const Pixel* from, int count, unsigned opacity);
void blend_faded_sse2(Pixel* to, const Pixel* from, int count, unsigned opacity);
void blend_faded_avx2(Pixel* to, const Pixel* from, int count, unsigned opacity);

}  // namespace hyrax
