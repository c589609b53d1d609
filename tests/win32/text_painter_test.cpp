// SPDX-License-Identifier: MIT
#include "daemon/win32/text_painter.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace hyrax;

TEST_CASE("a line of text is black, premultiplied and as wide as it is long") {
    const TextPainter paint = win32::make_text_painter();
    const Result<Image> word = paint("hyrax");
    const Result<Image> words = paint("hyrax \u00e4 hyrax");
    REQUIRE_MESSAGE(word, (word ? "" : word.error().message));
    REQUIRE(words);
    CHECK(word->size.width > 10);
    CHECK(words->size.width > 2 * word->size.width);
    CHECK(words->size.height == word->size.height);
    CHECK(std::ranges::any_of(word->pixels, [](Pixel pixel) { return alpha_of(pixel) > 200; }));
    CHECK(std::ranges::all_of(word->pixels, [](Pixel pixel) { return (pixel & 0xFFFFFFU) == 0; }));
    CHECK(paint("").has_value());
}
