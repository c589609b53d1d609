// SPDX-License-Identifier: MIT
// Pictures that somebody has looked at, drawn again by every kernel. HYRAX_WRITE_GOLDEN=1 draws
// them anew with the scalar one.
#include "daemon/core/atlas.h"
#include "daemon/core/blit.h"
#include "daemon/core/engine.h"
#include "daemon/core/files.h"
#include "daemon/headless/png_file.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <string>

using namespace hyrax;

namespace {

Image drawn(const Frame& frame, Size size, Kernel kernel) {
    Image image(size);
    compose(PixelView(image), {}, {0, 0, size.width, size.height}, frame, kernel);
    return image;
}

void check_golden(const std::string& name, const Frame& frame, Size size) {
    const auto path = std::filesystem::path(HYRAX_SOURCE_DIR) / "tests" / "golden" / name;
    if (std::getenv("HYRAX_WRITE_GOLDEN") != nullptr) {
        REQUIRE(write_png(path, drawn(frame, size, Kernel::scalar)));
    }
    const auto file = read_binary_file(path, max_image_file_bytes);
    REQUIRE(file);
    const Result<Image> golden = decode_png(*file);
    REQUIRE(golden);
    REQUIRE(golden->size == size);
    for (const Kernel kernel : available_blit_kernels()) {
        CHECK(drawn(frame, size, kernel).pixels == golden->pixels);
    }
}

// Side by side, at the scales that people use.
Frame row_of_scales(const SpriteSet& set, Atlas& atlas, std::initializer_list<double> scales) {
    Frame frame;
    int x = 0;
    for (const double scale : scales) {
        const Size size = scaled(set.cell, scale);
        const CellPicture picture = atlas.cell(set, 0, 0, false, size);
        frame.sprites.push_back({*picture.image, {x + picture.at.x, picture.at.y}, {}});
        x += size.width;
    }
    return frame;
}

}  // namespace

TEST_CASE("golden pictures: smooth scales") {
    const SpriteSet set = placeholder_sprite_set("hyrax");
    Atlas atlas;
    check_golden(
        "scales_smooth.png",
        row_of_scales(set, atlas, {0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0}),
        {696, 192}
    );
}

TEST_CASE("golden pictures: pixel art") {
    SpriteSet set = placeholder_sprite_set("hyrax");
    set.sheet = resampled(set.sheet, {0, 0, 96, 96}, {24, 24}, Filter::smooth);
    set.cell = {24, 24};
    set.filter = Filter::nearest;
    Atlas atlas;
    check_golden(
        "scales_pixel_art.png", row_of_scales(set, atlas, {1.0, 2.0, 3.0, 4.0}), {240, 96}
    );
}

TEST_CASE("golden pictures: over each other, facing both ways, faded, over every edge") {
    const SpriteSet set = placeholder_sprite_set("hyrax");
    Atlas atlas;
    Frame frame;
    const auto put = [&](bool left, int side, Point at, std::uint8_t opacity) {
        const CellPicture picture = atlas.cell(set, 0, 0, left, {side, side});
        const Point corner{at.x + picture.at.x, at.y + picture.at.y};
        frame.sprites.push_back({*picture.image, corner, {}, opacity});
    };
    put(false, 96, {-30, -20}, 255);
    put(true, 96, {20, 10}, 200);
    put(false, 144, {70, -40}, 255);
    put(true, 48, {60, 70}, 128);
    put(false, 120, {-50, 80}, 60);
    put(true, 96, {120, 60}, 255);
    check_golden("overlap.png", frame, {180, 130});
}
