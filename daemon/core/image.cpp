// SPDX-License-Identifier: MIT
#include "daemon/core/image.h"

#include <algorithm>
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

}  // namespace hyrax
