// SPDX-License-Identifier: MIT
// Pictures in other sizes, and the store that keeps them.
#include "daemon/core/atlas.h"

#include "daemon/core/resample.h"
#include "daemon/core/stage.h"
#include "tests/support/random_pixel.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <set>

using namespace hyrax;

namespace {

constexpr Pixel red = 0xFFFF0000U;
constexpr Pixel green = 0xFF00FF00U;
constexpr Pixel blue = 0xFF0000FFU;

bool premultiplied(Pixel pixel) {
    const unsigned a = alpha_of(pixel);
    return ((pixel >> 16U) & 0xFFU) <= a && ((pixel >> 8U) & 0xFFU) <= a && (pixel & 0xFFU) <= a;
}

bool visible_or_clear(Pixel pixel) {
    return alpha_of(pixel) >= least_alpha || pixel == 0;
}

Image noise(Size size, unsigned seed) {
    std::minstd_rand random(seed);
    Image image(size);
    for (Pixel& pixel : image.pixels) {
        pixel = random_pixel(random);
    }
    return image;
}

// Two cells of 8 x 8: an empty one between full neighbours cannot hide what bleeds into it.
SpriteSet striped_set() {
    SpriteSet set;
    set.name = "hyrax";
    set.cell = {8, 8};
    set.box = {1, 2, 6, 6};
    set.sheet = Image(Size{24, 8});
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 24; ++x) {
            set.sheet.at(x, y) = x < 8 ? red : (x < 16 ? Pixel{0} : blue);
        }
    }
    set.animations["idle"] = {{{0, ticks_per_second}}, true};
    return set;
}

SpriteSet full_set() {
    SpriteSet set = striped_set();
    std::ranges::replace(set.sheet.pixels, Pixel{0}, green);
    return set;
}

constexpr Size sizes[] = {{1, 1}, {3, 5}, {7, 8}, {8, 8}, {9, 8}, {12, 12}, {16, 16}, {61, 3}};

}  // namespace

TEST_CASE("pictures in other sizes stay premultiplied and keep no pixel that nobody sees") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Image image = noise({16, 16}, seed);
        for (const Size size : sizes) {
            for (const Filter filter : {Filter::smooth, Filter::nearest}) {
                const Image made = resampled(image, {2, 3, 11, 13}, size, filter);
                REQUIRE(made.size == size);
                REQUIRE(std::ranges::all_of(made.pixels, premultiplied));
                REQUIRE(std::ranges::all_of(made.pixels, visible_or_clear));
            }
        }
    }
}

TEST_CASE("a plain picture stays plain in any size, up to its edges") {
    Image plain(Size{8, 8});
    std::ranges::fill(plain.pixels, 0xFF336699U);
    for (const Size size : sizes) {
        for (const Filter filter : {Filter::smooth, Filter::nearest}) {
            const Image made = resampled(plain, {0, 0, 8, 8}, size, filter);
            CHECK(std::ranges::count(made.pixels, 0xFF336699U) == size.width * size.height);
        }
    }
}

TEST_CASE("smaller pictures are means: two by two become one") {
    Image image(Size{2, 2});
    image.pixels = {0xFFFF0000U, 0xFF00FF00U, 0xFF0000FFU, 0x00000000U};
    const Image made = resampled(image, {0, 0, 2, 2}, {1, 1}, Filter::smooth);
    CHECK(made.pixels[0] == 0xBF404040U);  // 765 / 4 and 255 / 4, rounded
}

TEST_CASE("a mean in a whole ratio is exact, a picture in its own size is itself") {
    const Image image = noise({12, 12}, 3);
    const Image same = resampled(image, {0, 0, 12, 12}, {12, 12}, Filter::smooth);
    const Image third = resampled(image, {0, 0, 12, 12}, {4, 4}, Filter::smooth);
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 12; ++x) {
            const Pixel pixel = image.at(x, y);
            CHECK(same.at(x, y) == (alpha_of(pixel) < least_alpha ? 0 : pixel));
        }
    }
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            int alpha = 0;
            for (int i = 0; i < 9; ++i) {
                alpha += static_cast<int>(alpha_of(image.at(3 * x + i % 3, 3 * y + i / 3)));
            }
            CHECK(std::abs(static_cast<int>(alpha_of(third.at(x, y))) * 9 - alpha) <= 5);
        }
    }
}

TEST_CASE("pixel art at a whole scale is made of squares") {
    const Image image = noise({5, 4}, 9);
    const Image made = resampled(image, {0, 0, 5, 4}, {15, 12}, Filter::nearest);
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 15; ++x) {
            const Pixel pixel = image.at(x / 3, y / 3);
            REQUIRE(made.at(x, y) == (alpha_of(pixel) < least_alpha ? 0 : pixel));
        }
    }
}

TEST_CASE("cells do not bleed into each other") {
    const SpriteSet set = striped_set();
    Atlas atlas;
    for (const Size size : sizes) {
        for (const bool left : {false, true}) {
            const auto only = [&](int cell, Pixel colour) {
                const CellPicture picture = atlas.cell(set, 0, cell, left, size);
                CHECK(picture.image->size == (colour == 0 ? Size{} : size));
                CHECK(
                    std::ranges::count(picture.image->pixels, colour) ==
                    std::ssize(picture.image->pixels)
                );
            };
            only(0, red);
            only(1, 0);
            only(2, blue);
        }
    }
}

TEST_CASE("only what is visible of a cell is drawn, and it stands where it stood in the cell") {
    SpriteSet set = striped_set();
    const Image ink = noise({24, 8}, 11);
    // The middle cell's pixels lie in columns 2 to 6 and rows 3 to 4; the others' everywhere.
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 24; ++x) {
            const bool in_middle = x >= 8 && x < 16;
            const bool is_seen = x >= 10 && x < 15 && y >= 3 && y < 5;
            set.sheet.at(x, y) = !in_middle || is_seen ? ink.at(x, y) | 0x80000000U : 0;
        }
    }
    Atlas atlas;
    const CellPicture right = atlas.cell(set, 0, 1, false, set.cell);
    CHECK(right.at == Point{2, 3});
    CHECK(right.image->size == Size{5, 2});
    CHECK(atlas.cell(set, 0, 1, true, set.cell).at == Point{1, 3});
    for (const Size size : sizes) {
        const Image whole = resampled(set.sheet, {8, 0, 8, 8}, size, set.filter);
        for (const bool left : {false, true}) {
            const auto [image, at] = atlas.cell(set, 0, 1, left, size);
            const Rect seen{at.x, at.y, image->size.width, image->size.height};
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x) {
                    const Pixel expected = whole.at(left ? size.width - 1 - x : x, y);
                    const bool is_drawn = seen.contains(Point{x, y});
                    REQUIRE((is_drawn ? image->at(x - at.x, y - at.y) : Pixel{0}) == expected);
                }
            }
        }
    }
}

TEST_CASE("the atlas makes each picture once, also the empty one") {
    const SpriteSet set = striped_set();
    Atlas atlas;
    std::set<const Image*> images;
    for (int frame = 0; frame < 10; ++frame) {
        atlas.begin_frame();
        for (const int cell : {0, 1, 2}) {
            for (const bool left : {false, true}) {
                images.insert(atlas.cell(set, 0, cell, left, {16, 16}).image);
                images.insert(atlas.cell(set, 0, cell, left, {4, 4}).image);
            }
        }
    }
    CHECK(images.size() == 12);
    CHECK(atlas.made() == 12);
    CHECK(atlas.bytes() == 4 * (16 * 16 + 4 * 4) * sizeof(Pixel));  // Cell 1 is empty.
    // Another set of the same name and size is another one.
    CHECK(images.count(atlas.cell(set, 1, 0, false, {16, 16}).image) == 0);
    atlas.clear();
    CHECK(atlas.bytes() == 0);
}

TEST_CASE("above its limit the atlas drops what was shown longest ago, and nothing in use") {
    const SpriteSet set = full_set();
    constexpr std::size_t cell_bytes = 16 * 16 * sizeof(Pixel);
    Atlas atlas(3 * cell_bytes);
    const auto show = [&](int cell, bool left = false) {
        return atlas.cell(set, 0, cell, left, {16, 16}).image;
    };
    show(0);
    atlas.begin_frame();
    const Image* const second = show(1);
    atlas.begin_frame();
    const Image* const third = show(2);
    CHECK(atlas.bytes() == 3 * cell_bytes);
    show(0, true);  // Cell 0 goes: 1 was shown a frame ago.
    CHECK(atlas.bytes() == 3 * cell_bytes);
    CHECK(atlas.made() == 4);
    CHECK(show(1) == second);
    CHECK(show(2) == third);
    CHECK(atlas.made() == 4);
    show(0);  // All others are in use: the limit must wait.
    CHECK(atlas.made() == 5);
    CHECK(atlas.bytes() == 4 * cell_bytes);
    CHECK(third->pixels.size() == 16 * 16);
    atlas.begin_frame();
    atlas.begin_frame();
    atlas.cell(set, 0, 0, false, {12, 16});
    CHECK(atlas.bytes() <= 3 * cell_bytes);
}

TEST_CASE("a picture of the frame before stays, whatever the limit") {
    const SpriteSet set = full_set();
    constexpr std::size_t cell_bytes = 16 * 16 * sizeof(Pixel);
    Atlas atlas(cell_bytes);
    const auto show = [&](int cell) { return atlas.cell(set, 0, cell, false, {16, 16}).image; };
    const Image* const first = show(0);
    atlas.begin_frame();
    const Image* const second = show(1);
    CHECK(first->pixels.size() == 16 * 16);
    CHECK(atlas.bytes() == 2 * cell_bytes);
    atlas.begin_frame();
    show(2);
    CHECK(second->pixels.size() == 16 * 16);
    CHECK(atlas.bytes() == 2 * cell_bytes);
}

TEST_CASE("a scaled pet stands with its feet on its box's bottom edge") {
    const std::vector<SpriteSet> sets{striped_set()};
    Engine engine(kinds_of(sets), {.physics = {.gravity = 0.0, .air_drag = 1.0}}, 1);
    engine.set_arena(Arena({{{0, 0, 400, 300}, {0, 0, 400, 300}, true, {}}}, FloorEdge::screen));
    Atlas atlas;
    for (const double scale : {0.25, 0.5, 0.75, 1.0, 1.3, 1.5, 2.0, 3.7, 4.0}) {
        const auto id = engine.spawn({.at = Vec2{100.0, 100.0}, .scale = scale});
        REQUIRE(id);
        const Staged shown = staged(engine, sets, atlas, {});
        const Sprite& sprite = shown.frame.sprites.at(0);
        const Pet& pet = *engine.find(*id);
        const Size box = engine.box_of(pet);
        CHECK(sprite.image->size.width == scaled(Size{8, 8}, scale).width);
        // The feet are in the middle of the cell and on its bottom edge.
        CHECK(std::abs(sprite.bounds().bottom() - (100 + box.height)) <= 1);
        CHECK(
            std::abs(sprite.at.x + sprite.image->size.width / 2.0 - (100 + box.width / 2.0)) <= 1.0
        );
        REQUIRE(engine.remove(*id));
    }
}

TEST_CASE("opacities of settings and pet multiply, and no pet is lost") {
    const std::vector<SpriteSet> sets{striped_set()};
    Engine engine(kinds_of(sets), {}, 1);
    engine.set_arena(Arena({{{0, 0, 400, 300}, {0, 0, 400, 300}, true, {}}}, FloorEdge::screen));
    const auto id = engine.spawn({.at = Vec2{100.0, 100.0}});
    REQUIRE(id);
    Atlas atlas;
    const auto shown = [&](double opacity) {
        return staged(engine, sets, atlas, {.opacity = opacity}).frame.sprites.at(0).opacity;
    };
    CHECK(shown(1.0) == 255);
    CHECK(shown(0.5) == 128);
    REQUIRE(engine.set_opacity(*id, 0.5));
    CHECK(shown(1.0) == 128);
    CHECK(shown(0.5) == 64);
    CHECK(shown(0.1) == 26);
    CHECK_FALSE(engine.set_opacity(*id, 0.05));
    CHECK_FALSE(engine.spawn({.opacity = 1.5}));
    CHECK(
        engine.set_opacity(*id, 0.0).error().message ==
        "set_opacity: expected an opacity from 0.1 to 1, got 0"
    );
}

TEST_CASE("a pet from a screen that has gone appears by and by, and then costs no frame") {
    const std::vector<SpriteSet> sets{striped_set()};
    Engine engine(kinds_of(sets), {}, 1);
    const Monitor main{{0, 0, 400, 300}, {0, 0, 400, 300}, true, {}};
    const Monitor left{{-400, 0, 400, 300}, {-400, 0, 400, 300}, false, {}};
    engine.set_arena(Arena({main, left}, FloorEdge::screen));
    REQUIRE(engine.spawn({.at = Vec2{100.0, 292.0}}));
    REQUIRE(engine.spawn({.at = Vec2{-100.0, 292.0}}));
    engine.advance(0);
    Atlas atlas;
    Ticks now = 50 * ticks_per_second;
    const auto at = [&](Ticks later) {
        engine.advance(now + later);
        return staged(engine, sets, atlas, {.now = now + later});
    };
    const auto second = [](const Staged& shown) { return shown.frame.sprites.at(1).opacity; };
    CHECK(second(at(0)) == 255);
    engine.set_arena(Arena({main}, FloorEdge::screen));
    const Staged begin = at(0);
    CHECK(begin.frame.sprites.at(0).opacity == 255);
    CHECK(second(begin) == 26);
    CHECK(begin.next_change <= now + 20 * ticks_per_ms);
    CHECK(second(at(125 * ticks_per_ms)) == 128);
    const Staged end = at(250 * ticks_per_ms);
    CHECK(second(end) == 255);
    CHECK(end.next_change > now + 300 * ticks_per_ms);
    // Screens that change but stay make nobody vanish.
    now += ticks_per_second;
    engine.set_arena(Arena({{{0, 0, 500, 300}, {0, 0, 500, 300}, true, {}}}, FloorEdge::screen));
    CHECK(second(at(0)) == 255);
}

TEST_CASE("huge cells are not made larger") {
    SpriteSet set = striped_set();
    set.cell = {4096, 8};
    CHECK(kinds_of({set})[0].largest_scale == 1.0);
    set.cell = {512, 8};
    CHECK(kinds_of({set})[0].largest_scale == 4.0);
    set.cell = {8, 8};
    CHECK(kinds_of({set})[0].largest_scale == 8.0);
}
