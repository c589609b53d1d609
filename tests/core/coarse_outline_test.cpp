// SPDX-License-Identifier: MIT
#include "daemon/core/coarse_outline.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace hyrax;

namespace {

Image dotted(Size size, unsigned seed) {
    Image image(size);
    std::mt19937 random(seed);
    for (Pixel& pixel : image.pixels) {
        pixel = random() % 9 == 0 ? 0x80000000U | (random() & 0x7f7f7fU) : 0U;
    }
    return image;
}

}  // namespace

TEST_CASE("rows of a band share their outline, and no visible pixel changes") {
    for (const int rows : {1, 4, 8}) {
        CAPTURE(rows);
        const Image before = dotted({600, 37}, 5);
        Image after = before;
        coarsen_outline(PixelView(after), {0, 0, 600, 37}, rows);
        for (int y = 0; y < 37; ++y) {
            const int band = y / rows * rows;
            for (int x = 0; x < 600; ++x) {
                bool any = false;
                for (int k = band; k < std::min(band + rows, 37); ++k) {
                    any = any || before.at(x, k) != 0;
                }
                const Pixel wanted =
                    before.at(x, y) != 0 ? before.at(x, y) : (any ? faint_pixel : 0U);
                REQUIRE(after.at(x, y) == wanted);
            }
        }
    }
}

TEST_CASE("only the part is touched") {
    Image image = dotted({300, 32}, 6);
    const Image before = image;
    coarsen_outline(PixelView(image), {10, 8, 270, 16}, 8);
    int changed = 0;
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 300; ++x) {
            const bool inside = Rect{10, 8, 270, 16}.contains(Point{x, y});
            changed += inside && image.at(x, y) != before.at(x, y) ? 1 : 0;
            CHECK((inside || image.at(x, y) == before.at(x, y)));
        }
    }
    CHECK(changed > 100);
}

TEST_CASE("a part grows to whole bands within its area") {
    const Rect area{-100, -205, 400, 301};
    CHECK(whole_bands({0, -203, 10, 1}, area, 8) == Rect{0, -205, 10, 8});
    CHECK(whole_bands({0, -197, 10, 9}, area, 8) == Rect{0, -197, 10, 16});
    CHECK(whole_bands({0, 90, 10, 6}, area, 8) == Rect{0, 83, 10, 13});
    CHECK(whole_bands({0, -203, 10, 1}, area, 1) == Rect{0, -203, 10, 1});
}

TEST_CASE("few sprites keep their exact outline") {
    CHECK(outline_rows(0) == 1);
    CHECK(outline_rows(24) == 1);
    CHECK(outline_rows(25) == 4);
    CHECK(outline_rows(100) == 8);
}
