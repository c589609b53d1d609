// SPDX-License-Identifier: MIT
#include "daemon/core/coarse_outline.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace hyrax {
namespace {

/// Columns that are worked on together: a number that the compiler knows becomes vectors.
constexpr int chunk = 16;

using Columns = std::array<Pixel, chunk>;

/// Faint where a row of the band has a pixel, else 0.
Columns shared_outline(const Pixel* first, std::ptrdiff_t stride, int rows) {
    Columns seen{};
    for (int y = 0; y < rows; ++y, first += stride) {
        for (std::size_t x = 0; x < chunk; ++x) {
            seen[x] |= first[x];
        }
    }
    for (Pixel& any : seen) {
        any = any != 0 ? faint_pixel : 0U;
    }
    return seen;
}

void coarsen_chunk(Pixel* first, std::ptrdiff_t stride, int rows) {
    const Columns outline = shared_outline(first, stride, rows);
    if (outline == Columns{}) {
        return;
    }
    for (int y = 0; y < rows; ++y, first += stride) {
        for (std::size_t x = 0; x < chunk; ++x) {
            first[x] |= first[x] == 0 ? outline[x] : 0U;
        }
    }
}

void coarsen_column(Pixel* first, std::ptrdiff_t stride, int rows) {
    Pixel seen = 0;
    for (int y = 0; y < rows; ++y) {
        seen |= first[y * stride];
    }
    for (int y = 0; seen != 0 && y < rows; ++y) {
        Pixel& pixel = first[y * stride];
        pixel = pixel != 0 ? pixel : faint_pixel;
    }
}

}  // namespace

int outline_rows(std::size_t sprites) {
    constexpr std::size_t few = 24;
    constexpr std::size_t many = 64;
    return sprites <= few ? 1 : sprites <= many ? 4 : 8;
}

Rect whole_bands(Rect part, const Rect& area, int rows) {
    const int top = (part.y - area.y) / rows * rows;
    const int bottom = (part.bottom() - area.y + rows - 1) / rows * rows;
    part.y = area.y + top;
    part.height = std::min(bottom, area.height) - top;
    return part;
}

void coarsen_outline(const PixelView& target, const Rect& part, int rows) {
    if (rows <= 1) {
        return;
    }
    for (int y = part.y; y < part.bottom(); y += rows) {
        const int band = std::min(rows, part.bottom() - y);
        Pixel* at = target.pixels + std::ptrdiff_t{y} * target.stride + part.x;
        Pixel* const end = at + part.width;
        for (; end - at >= chunk; at += chunk) {
            coarsen_chunk(at, target.stride, band);
        }
        for (; at != end; ++at) {
            coarsen_column(at, target.stride, band);
        }
    }
}

}  // namespace hyrax
