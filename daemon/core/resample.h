// SPDX-License-Identifier: MIT
// Pictures in other sizes.
#pragma once

#include "daemon/core/image.h"
#include "physics/geometry.h"

#include <cstdint>

namespace hyrax {

enum class Filter : std::uint8_t {
    smooth,   ///< Smaller: the mean of the area; larger: Catmull-Rom. For drawings and photographs.
    nearest,  ///< Pixels become rectangles. For pixel art, at whole scales.
};

/// Fainter pixels cannot be seen, but would catch clicks.
inline constexpr unsigned least_alpha = 8;

/// `part` of the image in this size (positive). Nothing outside the part is looked at. The result
/// is premultiplied, too: no colour exceeds alpha, and alpha below least_alpha is cleared.
Image resampled(const Image& image, const Rect& part, Size size, Filter filter);

}  // namespace hyrax
