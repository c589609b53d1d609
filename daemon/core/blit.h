// SPDX-License-Identifier: MIT
// Draws sprites into pixels: premultiplied source-over (Porter and Duff 1984).
#pragma once

#include "daemon/core/frame.h"
#include "daemon/core/image.h"
#include "physics/geometry.h"

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

/// Draws `source` of the image with its top-left corner at `at`, clipped to `clip` and to the
/// target. Each channel is rounded to the nearest value, so an opaque pixel replaces the target.
void blit(const PixelView& target, const Rect& clip, Point at, const Image& image, Rect source);

/// Redraws `area` (virtual desktop) of a frame into a target whose pixel (0, 0) is `origin`.
void compose(const PixelView& target, Point origin, const Rect& area, const Frame& frame);

}  // namespace hyrax
