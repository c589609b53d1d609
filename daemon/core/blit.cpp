// SPDX-License-Identifier: MIT
#include "daemon/core/blit.h"

#include <algorithm>
#include <cstddef>

namespace hyrax {
namespace {

Pixel* row(const PixelView& view, int x, int y) {
    return view.pixels + static_cast<std::ptrdiff_t>(y) * view.stride + x;
}

// Two 8-bit channels in the low bytes of two 16-bit lanes, each times factor / 255, rounded to
// nearest: (v + 128 + ((v + 128) >> 8)) >> 8 equals round(v / 255) for v up to 255 * 255.
std::uint32_t scaled_pair(std::uint32_t pair, std::uint32_t factor) {
    const std::uint32_t v = pair * factor + 0x00800080U;
    return ((v + ((v >> 8U) & 0x00ff00ffU)) >> 8U) & 0x00ff00ffU;
}

Pixel source_over(Pixel source, Pixel target) {
    const std::uint32_t remaining = 255U - alpha_of(source);
    const std::uint32_t red_blue = scaled_pair(target & 0x00ff00ffU, remaining);
    const std::uint32_t alpha_green = scaled_pair((target >> 8U) & 0x00ff00ffU, remaining);
    return source + (red_blue | (alpha_green << 8U));
}

}  // namespace

void erase(const PixelView& target, Rect area) {
    const Rect part = intersection(area, {0, 0, target.size.width, target.size.height});
    for (int y = part.y; y < part.bottom(); ++y) {
        std::fill_n(row(target, part.x, y), part.width, Pixel{0});
    }
}

void blit(const PixelView& target, const Rect& clip, Point at, const Image& image, Rect source) {
    const Rect limits = intersection(clip, {0, 0, target.size.width, target.size.height});
    const Rect part = intersection({at.x, at.y, source.width, source.height}, limits);
    for (int y = part.y; y < part.bottom(); ++y) {
        const int source_x = source.x + part.x - at.x;
        const int source_y = source.y + y - at.y;
        const Pixel* from =
            &image.pixels
                 [static_cast<std::size_t>(source_y) * static_cast<std::size_t>(image.size.width) +
                  static_cast<std::size_t>(source_x)];
        Pixel* to = row(target, part.x, y);
        for (int i = 0; i < part.width; ++i) {
            to[i] = source_over(from[i], to[i]);
        }
    }
}

void compose(const PixelView& target, Point origin, const Rect& area, const Frame& frame) {
    const Rect local{area.x - origin.x, area.y - origin.y, area.width, area.height};
    erase(target, local);
    for (const Sprite& sprite : frame.sprites) {
        if (!intersection(sprite.bounds(), area).empty()) {
            const Point at{sprite.at.x - origin.x, sprite.at.y - origin.y};
            blit(target, local, at, *sprite.image, sprite.source);
        }
    }
}

}  // namespace hyrax
