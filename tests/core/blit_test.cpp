// SPDX-License-Identifier: MIT
// The blitter's kernels: the same bits, and nothing allocated.
#include "daemon/core/blit.h"

#include "tests/support/allocation_counter.h"
#include "tests/support/random_pixel.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>

using namespace hyrax;

namespace {

// Runs of clear, opaque and translucent pixels, as in sprites, and single ones among others.
Image picture(Size size, std::minstd_rand& random) {
    Image image(size);
    unsigned sort = 0;
    for (Pixel& pixel : image.pixels) {
        if (random_up_to(5, random) == 0) {
            sort = random_up_to(3, random);
        }
        pixel = sort == 0 ? 0 : random_pixel(random, sort == 1 ? 255 : random_up_to(255, random));
    }
    return image;
}

}  // namespace

TEST_CASE("all kernels draw the same bits: random pictures, places, clips, opacities") {
    std::minstd_rand random(11);
    const auto up_to = [&random](int most) {
        return static_cast<int>(random_up_to(static_cast<unsigned>(most), random));
    };
    for (int round = 0; round < 4000; ++round) {
        const Image ink = picture({1 + up_to(40), 1 + up_to(12)}, random);
        const Image paper = picture({37, 15}, random);
        const Point at{up_to(60) - 20, up_to(30) - 10};
        const Rect clip{up_to(40) - 5, up_to(20) - 5, up_to(45), up_to(25)};
        const auto opacity = static_cast<std::uint8_t>(up_to(3) == 0 ? up_to(255) : 255);

        Image expected = paper;
        blit(PixelView(expected), clip, {ink, at, opacity}, Kernel::scalar);
        for (const Kernel kernel : available_blit_kernels()) {
            CAPTURE(name(kernel));
            CAPTURE(round);
            Image drawn = paper;
            blit(PixelView(drawn), clip, {ink, at, opacity}, kernel);
            REQUIRE(drawn.pixels == expected.pixels);
        }
    }
}

TEST_CASE("every alpha and every opacity over the values of a channel") {
    Image ink(Size{256, 1});
    for (unsigned a = 0; a < 256; ++a) {
        ink.pixels[a] = a << 24U | (a / 2) << 16U | a;
    }
    for (const Kernel kernel : available_blit_kernels()) {
        CAPTURE(name(kernel));
        for (unsigned opacity = 0; opacity < 256; ++opacity) {
            unsigned wrong = 0;
            for (unsigned under = 0; under < 256; under += 15) {
                Image paper(Size{256, 1});
                std::ranges::fill(paper.pixels, 0xFF000000U | under);
                const Stamp stamp{ink, {}, static_cast<std::uint8_t>(opacity)};
                blit(PixelView(paper), {0, 0, 256, 1}, stamp, kernel);
                for (unsigned a = 0; a < 256; ++a) {
                    const unsigned faded = (a * opacity * 2 + 255) / 510;
                    const unsigned blue = faded + (under * (255 - faded) * 2 + 255) / 510;
                    const Pixel pixel = paper.pixels[a];
                    wrong += pixel % 256 != blue || alpha_of(pixel) != 255 ? 1U : 0U;
                }
            }
            REQUIRE(wrong == 0);
        }
    }
}

TEST_CASE("composing allocates nothing, with any kernel") {
    std::minstd_rand random(5);
    const auto up_to = [&random](int most) {
        return static_cast<int>(random_up_to(static_cast<unsigned>(most), random));
    };
    const Image ink = picture({64, 64}, random);
    Frame frame;
    for (std::uint32_t i = 0; i < 50; ++i) {
        const Point at{up_to(400) - 32, up_to(300) - 32};
        frame.sprites.push_back({ink, at, {i, 1}});
        frame.sprites.back().opacity = i % 3 == 0 ? 100 : 255;
    }
    Image canvas(Size{400, 300});
    const PixelView view(canvas);
    REQUIRE(available_blit_kernels().back() == best_blit_kernel());
    const std::size_t before = allocations();
    for (int i = 0; i < 1000; ++i) {
        for (Sprite& sprite : frame.sprites) {
            sprite.at.x += i % 2 == 0 ? 3 : -3;
        }
        for (const Kernel kernel : available_blit_kernels()) {
            compose(view, {-10, -10}, {20, 15, 200, 150}, frame, kernel);
        }
    }
    CHECK(allocations() == before);
    const auto one_more = std::make_unique<int>(1);
    CHECK(*one_more + allocations() > before + 1);
}
