// SPDX-License-Identifier: MIT
#include "daemon/core/image.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace hyrax {

Rect visible_part(const Image& image, const Rect& part) {
    Rect seen{part.x, part.y, 0, 0};
    for (int y = part.y; y < part.bottom(); ++y) {
        const auto row = image.pixels.begin() + std::ptrdiff_t{y} * image.size.width;
        const auto end = row + part.right();
        const auto is_visible = [](Pixel pixel) { return pixel != 0; };
        const auto first = std::find_if(row + part.x, end, is_visible);
        if (first == end) {
            continue;
        }
        const auto last = std::find_if(
            std::make_reverse_iterator(end), std::make_reverse_iterator(first), is_visible
        );
        const int x = static_cast<int>(first - row);
        seen = united(seen, {x, y, static_cast<int>(last.base() - first), 1});
    }
    return seen;
}

Image part_of(const Image& image, const Rect& part) {
    Image result(Size{part.width, part.height});
    auto to = result.pixels.begin();
    for (int y = part.y; y < part.bottom(); ++y) {
        const auto from = image.pixels.begin() + std::ptrdiff_t{y} * image.size.width + part.x;
        to = std::copy_n(from, part.width, to);
    }
    return result;
}

void mirror(Image& image) {
    const auto begin = image.pixels.begin();
    for (int y = 0; y < image.size.height; ++y) {
        const auto row = begin + std::ptrdiff_t{y} * image.size.width;
        std::reverse(row, row + image.size.width);
    }
}

}  // namespace hyrax
