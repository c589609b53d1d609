// SPDX-License-Identifier: MIT
// Draws sprites into pixels: premultiplied source-over (Porter and Duff 1984).
#pragma once

#include "daemon/core/frame.h"
#include "daemon/core/image.h"
#include "physics/batch.h"
#include "physics/geometry.h"

#include <cstdint>
#include <span>

namespace hyrax {

/// Pixels owned by somebody else: an image, or a DIB section.
struct PixelView {
    Pixel* pixels = nullptr;
    int stride = 0;  ///< Pixels from one row to the next.
    Size size;

    PixelView() = default;
    PixelView(Pixel* first, int pixels_per_row, Size view_size)
        : pixels(first), stride(pixels_per_row), size(view_size) {}
    explicit PixelView(Image& image)
        : pixels(image.pixels.data()), stride(image.size.width), size(image.size) {}
};

/// Sets the part of `area` that lies in the target to transparent.
void erase(const PixelView& target, Rect area);

/// The blitter's share of available_kernels(): scalar, SSE2, AVX2. They give the same bits.
std::span<const Kernel> available_blit_kernels();
/// The quickest of them.
Kernel best_blit_kernel();

/// A picture, and where it goes.
struct Stamp {
    const Image& image;
    Point at;                    ///< Of its top-left corner.
    std::uint8_t opacity = 255;  ///< 0 draws nothing.
};

/// Draws the stamp, clipped to `clip` and to the target. Each channel is rounded to the nearest
/// value, first for the opacity, then for source-over, so an opaque pixel replaces the target.
void blit(
    const PixelView& target,
    const Rect& clip,
    const Stamp& stamp,
    Kernel kernel = best_blit_kernel()
);

/// Redraws `area` (virtual desktop) of a frame into a target whose pixel (0, 0) is `origin`.
/// Allocates nothing.
void compose(
    const PixelView& target,
    Point origin,
    const Rect& area,
    const Frame& frame,
    Kernel kernel = best_blit_kernel()
);

/// The same for several parts, which may overlap, of a target that shows an earlier frame: pixels
/// are erased only at `before`, the places of its sprites.
void recompose(
    const PixelView& target,
    Point origin,
    std::span<const Rect> parts,
    std::span<const Rect> before,
    const Frame& frame,
    Kernel kernel = best_blit_kernel()
);

}  // namespace hyrax
