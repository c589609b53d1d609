// SPDX-License-Identifier: MIT
// The blitter against GDI+.
#include "daemon/win32/gdiplus_renderer.h"

#include "daemon/core/atlas.h"
#include "daemon/core/files.h"
#include "daemon/win32/image_decoder.h"
#include "daemon/win32/surface.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

using namespace hyrax;
using namespace hyrax::win32;

namespace {

constexpr Size pane{300, 260};
constexpr Point origin{-50, -40};
constexpr Rect everything{origin.x, origin.y, pane.width, pane.height};

SpriteSet shipped_set() {
    auto set = load_sprite_set(
        path_from_utf8(HYRAX_SOURCE_DIR "/config/sprites/hyrax"), make_gdiplus_decoder()
    );
    REQUIRE(set);
    return *std::move(set);
}

// A set and what is cut from it.
struct Pictures {
    SpriteSet set = shipped_set();
    Atlas atlas{};

    Sprite sprite(int cell, bool left, Point at, std::uint8_t opacity = 255, int side = 128) {
        const CellPicture picture = atlas.cell(set, 0, cell, left, {side, side});
        const Point corner{at.x + picture.at.x, at.y + picture.at.y};
        return {*picture.image, corner, {}, opacity};
    }
};

// The largest difference of a channel between both renderers, drawn onto surfaces of the overlay.
int difference(const Frame& frame, const Rect& area) {
    Surface surface;
    REQUIRE(surface.make_room(pane, pane));
    const PixelView view = surface.view(pane);
    const auto drawn = [&](auto render) {
        // What was there before must go within the area, and stay outside.
        for (int y = 0; y < pane.height; ++y) {
            std::fill_n(view.pixels + y * view.stride, pane.width, 0x80402010U);
        }
        render(view, origin, area, frame);
        std::vector<Pixel> pixels;
        for (int y = 0; y < pane.height; ++y) {
            const Pixel* const row = view.pixels + y * view.stride;
            pixels.insert(pixels.end(), row, row + pane.width);
        }
        return pixels;
    };
    const std::vector<Pixel> reference = drawn(compose_with_gdiplus);
    const std::vector<Pixel> ours =
        drawn([](const PixelView& target, Point corner, const Rect& part, const Frame& shown) {
            compose(target, corner, part, shown);
        });
    REQUIRE(std::ranges::count_if(ours, [](Pixel p) { return alpha_of(p) > 8; }) > 500);
    int most = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        for (const unsigned shift : {0U, 8U, 16U, 24U}) {
            const auto channel = [shift](Pixel pixel) {
                return static_cast<int>((pixel >> shift) & 0xFFU);
            };
            most = std::max(most, std::abs(channel(ours[i]) - channel(reference[i])));
        }
    }
    return most;
}

}  // namespace

TEST_CASE("both renderers agree within 1 on every cell of the sheet, both ways round") {
    const GdiplusSession session;
    Pictures pictures;
    const SpriteSet& set = pictures.set;
    const int cells =
        set.sheet.size.width / set.cell.width * set.sheet.size.height / set.cell.height;
    for (int cell = 0; cell < cells; ++cell) {
        for (const bool left : {false, true}) {
            CAPTURE(cell);
            CAPTURE(left);
            CHECK(
                difference({{pictures.sprite(cell, left, {cell - 7, 2 * cell})}}, everything) <= 1
            );
        }
    }
}

TEST_CASE("both renderers agree within 1 at every edge and in a dirty rectangle") {
    const GdiplusSession session;
    Pictures pictures;
    for (const Point at : {Point{-110, 20}, Point{190, 30}, Point{40, -110}, Point{30, 160}}) {
        CAPTURE(at.x);
        CAPTURE(at.y);
        CHECK(difference({{pictures.sprite(3, false, at)}}, everything) <= 1);
    }
    CHECK(difference({{pictures.sprite(3, true, {20, 10})}}, {40, 40, 71, 53}) <= 1);
}

TEST_CASE("both renderers agree within 1 with opacity") {
    const GdiplusSession session;
    Pictures pictures;
    for (const int opacity : {26, 64, 128, 200, 254}) {
        CAPTURE(opacity);
        const auto faded = static_cast<std::uint8_t>(opacity);
        CHECK(difference({{pictures.sprite(5, false, {30, 20}, faded)}}, everything) <= 1);
    }
}

TEST_CASE("both renderers agree within 1 on scaled cells") {
    const GdiplusSession session;
    Pictures pictures;
    for (const int side : {64, 96, 192}) {
        CAPTURE(side);
        CHECK(difference({{pictures.sprite(6, true, {10, 5}, 255, side)}}, everything) <= 1);
    }
}

TEST_CASE("sprites over each other differ by 1 for each at most") {
    const GdiplusSession session;
    Pictures pictures;
    const Frame frame{
        {pictures.sprite(0, false, {10, 10}, 200),
         pictures.sprite(7, true, {60, 30}),
         pictures.sprite(12, false, {40, 60}, 100)}
    };
    CHECK(difference(frame, everything) <= 3);
}
