// SPDX-License-Identifier: MIT
#include "daemon/core/blit.h"

#include "daemon/core/blit_rows.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace hyrax {
namespace {

// In the order of Kernel.
constexpr std::array<Blend, 3> blends{&blend_scalar, &blend_sse2, &blend_avx2};
constexpr std::array<FadedBlend, 3> faded_blends{
    &blend_faded_scalar, &blend_faded_sse2, &blend_faded_avx2
};

constexpr unsigned opaque = 255;

Pixel* row(const PixelView& view, int x, int y) {
    return view.pixels + static_cast<std::ptrdiff_t>(y) * view.stride + x;
}

/// Rows that are drawn together: what is erased in them is still in the processor's own cache when
/// it is drawn over. A frame that comes every 16 ms finds none of its pixels there.
constexpr int band_px = 1 << 17;

void for_each_band(const Rect& part, const auto& draw) {
    const int rows = std::max(1, band_px / std::max(1, part.width));
    for (int y = part.y; y < part.bottom(); y += rows) {
        draw(Rect{part.x, y, part.width, std::min(rows, part.bottom() - y)});
    }
}

/// The rectangle as a target sees it whose pixel (0, 0) is `origin`.
Rect relative_to(Point origin, const Rect& rect) {
    return {rect.x - origin.x, rect.y - origin.y, rect.width, rect.height};
}

/// What of these places lies in the band. Where they crowd, the band itself has fewer pixels.
void erase_places(
    const PixelView& target, Point origin, const Rect& band, std::span<const Rect> places
) {
    long long pixels = 0;
    for (const Rect& place : places) {
        pixels += intersection(relative_to(origin, place), band).area();
    }
    if (pixels >= band.area()) {
        erase(target, band);
        return;
    }
    for (const Rect& place : places) {
        erase(target, intersection(relative_to(origin, place), band));
    }
}

}  // namespace

std::span<const Kernel> available_blit_kernels() {
    const std::span<const Kernel> all = available_kernels();
    return all.first(std::min(all.size(), blends.size()));
}

Kernel best_blit_kernel() {
    return std::min(best_kernel(), Kernel::avx2);
}

void erase(const PixelView& target, Rect area) {
    const Rect part = intersection(area, {0, 0, target.size.width, target.size.height});
    for (int y = part.y; y < part.bottom(); ++y) {
        std::fill_n(row(target, part.x, y), part.width, Pixel{0});
    }
}

void blit(const PixelView& target, const Rect& clip, const Stamp& stamp, Kernel kernel) {
    const Size size = stamp.image.size;
    const Rect limits = intersection(clip, {0, 0, target.size.width, target.size.height});
    const Rect part = intersection({stamp.at.x, stamp.at.y, size.width, size.height}, limits);
    if (part.empty()) {
        return;
    }
    const auto stride = static_cast<std::ptrdiff_t>(size.width);
    const Rows rows{
        .to = row(target, part.x, part.y),
        .to_stride = target.stride,
        .from = stamp.image.pixels.data() + (part.y - stamp.at.y) * stride + (part.x - stamp.at.x),
        .from_stride = stride,
        .width = part.width,
        .count = part.height,
    };
    const auto index = static_cast<std::size_t>(kernel);
    if (stamp.opacity == opaque) {
        blends[index](rows);
    } else {
        faded_blends[index](rows, stamp.opacity);
    }
}

void compose(
    const PixelView& target, Point origin, const Rect& area, const Frame& frame, Kernel kernel
) {
    recompose(target, origin, std::span(&area, 1), std::span(&area, 1), frame, kernel);
}

void recompose(
    const PixelView& target,
    Point origin,
    std::span<const Rect> parts,
    std::span<const Rect> before,
    const Frame& frame,
    Kernel kernel
) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Rect part = relative_to(origin, parts[i]);
        for_each_band(part, [&](const Rect& band) {
            erase_places(target, origin, band, before);
            // Where parts overlap, the frame stands already, and would be blended with itself.
            erase_places(target, origin, band, parts.first(i));
            for (const Sprite& sprite : frame.sprites) {
                const Point at{sprite.at.x - origin.x, sprite.at.y - origin.y};
                blit(target, band, {*sprite.image, at, sprite.opacity}, kernel);
            }
        });
    }
}

}  // namespace hyrax
