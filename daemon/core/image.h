// SPDX-License-Identifier: MIT
// Pictures in memory.
#pragma once

#include "daemon/core/result.h"
#include "physics/geometry.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace hyrax {

/// One pixel: 0xAARRGGBB with premultiplied colour, so R, G, B <= A. In memory (little endian)
/// this is the byte order of a 32-bit DIB.
using Pixel = std::uint32_t;

constexpr unsigned alpha_of(Pixel pixel) {
    return pixel >> 24U;
}

/// Rows from the top, without padding.
struct Image {
    Size size;
    std::vector<Pixel> pixels;

    Image() = default;
    explicit Image(Size image_size)
        : size(image_size),
          pixels(
              static_cast<std::size_t>(image_size.width) *
              static_cast<std::size_t>(image_size.height)
          ) {}

    Pixel& at(int x, int y) {
        return pixels
            [static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
             static_cast<std::size_t>(x)];
    }
    Pixel at(int x, int y) const {
        return pixels
            [static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
             static_cast<std::size_t>(x)];
    }
};

/// The smallest rectangle within `part` with all its pixels that are not transparent; without area
/// if there are none.
Rect visible_part(const Image& image, const Rect& part);
/// A copy of the part, which lies in the image.
Image part_of(const Image& image, const Rect& part);
/// Left and right change places.
void mirror(Image& image);

/// Limits that are checked before anything is decoded.
inline constexpr std::size_t max_image_file_bytes = 16U << 20U;
inline constexpr int max_image_side = 8192;

/// Decodes a PNG file's bytes into premultiplied pixels. Each desktop brings its own (GDI+,
/// libpng).
using ImageDecoder = std::function<Result<Image>(std::span<const std::byte> file)>;

}  // namespace hyrax
