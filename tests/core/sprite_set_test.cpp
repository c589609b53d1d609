// SPDX-License-Identifier: MIT
#include "daemon/core/sprite_set.h"

#include "daemon/core/files.h"
#include "tests/support/png_header.h"
#include "tests/support/temporary_folder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>

using namespace hyrax;

namespace {

namespace fs = std::filesystem;

// Every pixel tells its place: alpha is x + 16 y, except for colours.
Image numbered(Size size) {
    Image image(size);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] = static_cast<Pixel>(i) << 24U;
    }
    return image;
}

const ImageDecoder numbered_8_by_4 = [](std::span<const std::byte>) -> Result<Image> {
    return numbered({8, 4});
};

const std::string good = R"({
    "name": "cat", "sheet": "sheet.png",
    "cell": {"width": 4, "height": 2}, "anchor": {"x": 2, "y": 2},
    "box": {"x": 1, "y": 0, "width": 3, "height": 2},
    "animations": {
        "idle": {"frames": [{"cell": 0, "ms": 2400}, {"cell": 3, "ms": 100}], "loop": true},
        "wave": {"frames": [{"cell": 1, "ms": 5}]}
    }
})";

std::string changed(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

struct Folder {
    TemporaryFolder temporary;

    explicit Folder(std::string_view json) {
        temporary.write("sprite.json", json);
        temporary.write("sheet.png", png_header(8, 4));
    }
    Result<SpriteSet> load(const ImageDecoder& decode = numbered_8_by_4) const {
        return load_sprite_set(temporary.path(), decode);
    }
    // The failure, with the folder's path taken out.
    std::string complaint(const ImageDecoder& decode = numbered_8_by_4) const {
        const Result<SpriteSet> set = load(decode);
        std::string text = set ? "loaded it" : set.error().message;
        const std::string path = utf8_from_path(temporary.path() / "");
        for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path)) {
            text.erase(at, path.size());
        }
        return text;
    }
};

std::string complaint_about(std::string_view from, std::string_view to) {
    return Folder(changed(good, from, to)).complaint();
}

bool is_premultiplied(const Image& image) {
    return std::ranges::all_of(image.pixels, [](Pixel pixel) {
        const unsigned alpha = alpha_of(pixel);
        return (pixel >> 16U & 0xFFU) <= alpha && (pixel >> 8U & 0xFFU) <= alpha &&
               (pixel & 0xFFU) <= alpha;
    });
}

Animation animation_of(std::initializer_list<AnimationFrame> frames, bool loop) {
    return {.frames = frames, .loop = loop};
}

std::pair<int, Ticks> shown(const Animation& animation, Ticks elapsed) {
    const Shown now = shown_at(animation, elapsed);
    return {now.cell, now.until};
}

using CellUntil = std::pair<int, Ticks>;

}  // namespace

TEST_CASE("sprite set: an animation that ends stays on its last frame") {
    const Animation land = animation_of({{5, 10}, {6, 20}, {7, 30}}, false);
    CHECK(land.duration() == 60);
    CHECK(shown(land, 0) == CellUntil{5, 10});
    CHECK(shown(land, 9) == CellUntil{5, 10});
    CHECK(shown(land, 10) == CellUntil{6, 30});
    CHECK(shown(land, 29) == CellUntil{6, 30});
    CHECK(shown(land, 30) == CellUntil{7, never});
    CHECK(shown(land, 60) == CellUntil{7, never});
    CHECK(shown(land, 1'000'000) == CellUntil{7, never});
}

TEST_CASE("sprite set: a loop begins anew") {
    const Animation blink = animation_of({{5, 10}, {6, 20}}, true);
    CHECK(shown(blink, 0) == CellUntil{5, 10});
    CHECK(shown(blink, 29) == CellUntil{6, 30});
    CHECK(shown(blink, 30) == CellUntil{5, 40});
    const Ticks year = 365LL * 86'400 * ticks_per_second / 30 * 30;
    CHECK(shown(blink, year + 15) == CellUntil{6, year + 30});
}

TEST_CASE("sprite set: nobody wakes up for a frame that looks the same") {
    CHECK(shown(animation_of({{5, 10}}, true), 1234) == CellUntil{5, never});
    CHECK(shown(animation_of({{5, 10}, {5, 10}}, true), 3) == CellUntil{5, never});
    CHECK(shown(animation_of({{5, 10}, {6, 10}, {5, 10}}, true), 25) == CellUntil{5, 40});
    CHECK(shown(animation_of({{5, 10}, {6, 10}, {5, 10}}, true), 3) == CellUntil{5, 10});
    CHECK(shown(animation_of({{5, 10}, {6, 10}, {6, 10}}, false), 12) == CellUntil{6, never});
}

TEST_CASE("sprite set: a good folder is read") {
    const Result<SpriteSet> set = Folder(good).load();
    if (!set) {
        FAIL(set.error().message);
    }
    CHECK(set->name == "cat");
    CHECK(set->cell == Size{4, 2});
    CHECK(set->box == Rect{1, 0, 3, 2});
    CHECK(set->sheet.size == Size{8, 4});
    CHECK(set->cell_rect(0) == Rect{0, 0, 4, 2});
    CHECK(set->cell_rect(1) == Rect{4, 0, 4, 2});
    CHECK(set->cell_rect(3) == Rect{4, 2, 4, 2});
    REQUIRE(set->animations.size() == 2);
    const Animation& idle = set->animation("idle");
    CHECK(idle.loop);
    REQUIRE(idle.frames.size() == 2);
    CHECK(idle.frames[1].cell == 3);
    CHECK(idle.frames[1].duration == 100 * ticks_per_ms);
    CHECK_FALSE(set->animation("wave").loop);
    CHECK(&set->animation("fall") == &idle);
}

TEST_CASE("sprite set: no colour is above alpha, whatever the decoder says") {
    const Result<SpriteSet> set = Folder(good).load([](std::span<const std::byte>) {
        Image image({8, 4});
        std::ranges::fill(image.pixels, 0x80FF8010U);
        return image;
    });
    REQUIRE(set);
    CHECK(is_premultiplied(set->sheet));
    CHECK(set->sheet.at(3, 2) == 0x80808010U);
}

TEST_CASE("sprite set: pixels that nobody sees are cleared") {
    const Result<SpriteSet> set = Folder(good).load([](std::span<const std::byte>) {
        Image image({8, 4});
        std::ranges::fill(image.pixels, 0x08070605U);
        image.at(1, 0) = 0x07070707U;
        image.at(2, 0) = 0x01000000U;
        return Result<Image>(image);
    });
    REQUIRE(set);
    CHECK(set->sheet.at(0, 0) == 0x08070605U);
    CHECK(set->sheet.at(1, 0) == 0);
    CHECK(set->sheet.at(2, 0) == 0);
    CHECK(is_premultiplied(set->sheet));
}

TEST_CASE("sprite set: the name is the folder's where none is given") {
    const Folder folder(changed(good, R"("name": "cat",)", ""));
    CHECK(folder.load()->name == utf8_from_path(folder.temporary.path().filename()));
}

TEST_CASE("sprite set: what is missing") {
    const TemporaryFolder empty;
    CHECK(
        load_sprite_set(empty.path(), numbered_8_by_4).error().message ==
        utf8_from_path(empty.path() / "sprite.json") + ": there is no such file"
    );
    CHECK(
        complaint_about(R"("sheet": "sheet.png",)", "") == "sprite.json:1:1: \"sheet\" is missing"
    );
    CHECK(
        complaint_about(R"("idle")", R"("sit")") ==
        "sprite.json:5:19: /animations: \"idle\" is missing"
    );
    CHECK(
        complaint_about(R"(, "ms": 100)", "") ==
        "sprite.json:6:54: /animations/idle/frames/1: \"ms\" is missing"
    );
    CHECK(
        Folder("{}").complaint() == "sprite.json:1:1: \"sheet\" is missing\n"
                                    "sprite.json:1:1: \"cell\" is missing\n"
                                    "sprite.json:1:1: \"animations\" is missing"
    );
    CHECK(Folder("[]").complaint() == "sprite.json:1:1: must be an object { }, got a list [ ]");
    CHECK(Folder("").complaint() == "sprite.json: the file is empty; at least {} is needed");
}

TEST_CASE("sprite set: numbers have bounds") {
    CHECK(
        complaint_about("\"width\": 4", "\"width\": 0") ==
        "sprite.json:3:23: /cell/width: must be a whole number from 1 to 8192, got 0"
    );
    CHECK(
        complaint_about("\"ms\": 5", "\"ms\": 0") ==
        "sprite.json:7:47: /animations/wave/frames/0/ms: must be a whole number from 1 to 600000, "
        "got 0"
    );
    CHECK(complaint_about("\"ms\": 5", "\"ms\": 600001").contains("from 1 to 600000, got 600001"));
    CHECK(
        complaint_about("[{\"cell\": 1, \"ms\": 5}]", "[]") ==
        "sprite.json:7:28: /animations/wave/frames: must be a list [ ] of 1 to 1000 items, got 0"
    );
    CHECK(complaint_about("\"loop\": true", "\"loop\": 1").ends_with("must be true or false, got 1")
    );
    CHECK(
        complaint_about("\"cell\": 3", "\"cell\": 4") ==
        "sprite.json:6:63: /animations/idle/frames/1/cell: must be a whole number from 0 to 3, "
        "got 4"
    );
    CHECK(complaint_about("\"cell\": 3", "\"cell\": -1").contains("got -1"));
    CHECK(complaint_about("\"x\": 2, \"y\": 2", "\"x\": 2, \"y\": 3").contains("/anchor/y: "));
}

TEST_CASE("sprite set: the box lies within the cell") {
    CHECK(
        complaint_about("\"width\": 3", "\"width\": 4") ==
        "sprite.json:4:38: /box/width: must be a whole number from 1 to 3, got 4"
    );
    CHECK(complaint_about("\"width\": 3", "\"width\": 0").contains("/box/width: "));
    CHECK(complaint_about("{\"x\": 1, \"y\": 0,", "{\"x\": 1, \"y\": 1,")
              .contains("/box/height: must be a whole number from 1 to 1, got 2"));
    CHECK(complaint_about("{\"x\": 1, \"y\": 0,", "{\"x\": 1, \"y\": 2,").contains("/box/y: "));
    CHECK(complaint_about("{\"x\": 1, \"y\": 0,", "{\"x\": -1, \"y\": 0,").contains("/box/x: "));
}

TEST_CASE("sprite set: scale and filter") {
    const auto plain = Folder(good).load();
    REQUIRE(plain);
    CHECK(plain->scale == 1.0);
    CHECK(plain->filter == Filter::smooth);
    const std::string_view name = R"("name": "cat",)";
    const auto pixels = Folder(changed(good, name, R"("scale": 2.5, "filter": "nearest",)")).load();
    REQUIRE(pixels);
    CHECK(pixels->scale == 2.5);
    CHECK(pixels->filter == Filter::nearest);
    CHECK(
        complaint_about(name, R"("scale": 5,)") ==
        "sprite.json:2:14: /scale: must be a number from 0.25 to 4, got 5"
    );
    CHECK(complaint_about(name, R"("filter": "blurry",)").contains(R"(, got "blurry")"));
    CHECK(complaint_about(name, R"("filtr": "nearest",)").contains("filter"));
}

TEST_CASE("sprite set: slips in keys are found, other keys are left alone") {
    CHECK(
        complaint_about("\"loop\"", "\"lop\"") ==
        "sprite.json:6:79: /animations/idle/lop: unknown key; did you mean \"loop\"?"
    );
    CHECK(complaint_about("\"name\"", "\"licence\": \"CC0\", \"name\"") == "loaded it");
}

TEST_CASE("sprite set: the sheet stays inside the folder") {
    for (const char* bad :
         {"../sheet.png",
          "a/../../sheet.png",
          "/etc/passwd",
          "C:/sheet.png",
          "C:sheet.png",
          "a\\\\sheet.png",
          "./sheet.png",
          "",
          ".",
          "sheet.png:stream"}) {
        CHECK(
            complaint_about("sheet.png", bad) ==
            "sprite.json:2:29: /sheet: must be a file in this folder, such as \"sheet.png\", "
            "got \"" +
                std::string(bad) + "\""
        );
    }
    for (const char* const hidden : {".sheet.png", "below/.hidden/sheet.png"}) {
        CHECK(
            complaint_about("sheet.png", hidden) ==
            "sprite.json:2:29: /sheet: must be a file that is not hidden, got \"" +
                std::string(hidden) + "\""
        );
    }
    const Folder folder(changed(good, "sheet.png", "below/sheet.png"));
    CHECK(folder.complaint().ends_with("sheet.png: there is no such file"));
    folder.temporary.write("below/sheet.png", png_header(8, 4));
    CHECK(folder.complaint() == "loaded it");
}

TEST_CASE("sprite set: sheets that cannot be used") {
    const Folder folder(good);
    const auto complaint_of_sheet = [&](std::string_view content) {
        folder.temporary.write("sheet.png", content);
        return folder.complaint();
    };
    CHECK(complaint_of_sheet("") == "sheet.png: is not a PNG picture");
    CHECK(
        complaint_of_sheet("GIF89a, and then some more bytes") == "sheet.png: is not a PNG picture"
    );
    CHECK(complaint_of_sheet(png_header(8, 4).substr(0, 23)) == "sheet.png: is not a PNG picture");
    CHECK(
        complaint_of_sheet(png_header(9, 4)) ==
        "sheet.png: is 9 x 4 pixels, which is no whole number of cells of 4 x 2 "
        "(/cell in sprite.json)"
    );
    CHECK(complaint_of_sheet(png_header(8, 3)).contains("no whole number of cells"));
    CHECK(
        complaint_of_sheet(png_header(8196, 4)) ==
        "sheet.png: is 8196 x 4 pixels; 1 to 8192 a side are allowed"
    );
    CHECK(complaint_of_sheet(png_header(0xFFFFFFFF, 0)).contains("a side are allowed"));
    fs::resize_file(folder.temporary.path() / "sheet.png", max_image_file_bytes + 1);
    CHECK(
        folder.complaint() == "sheet.png: is too large: 16777217 bytes, at most 16777216 are read"
    );
    fs::remove(folder.temporary.path() / "sheet.png");
    CHECK(folder.complaint() == "sheet.png: there is no such file");
}

TEST_CASE("sprite set: a decoder's failure is passed on, a wrong result is noticed") {
    const Folder folder(good);
    CHECK(folder.complaint([](auto) -> Result<Image> {
        return failure("chunk IDAT is broken");
    }) == "sheet.png: cannot be decoded: chunk IDAT is broken");
    CHECK(folder.complaint([](auto) -> Result<Image> {
        return Image({4, 4});
    }) == "sheet.png: was decoded to another size than its header says");
    CHECK(folder.complaint([](auto) -> Result<Image> {
        Image image({8, 4});
        image.pixels.pop_back();
        return image;
    }) == "sheet.png: was decoded to another size than its header says");
}

TEST_CASE("sprite set: the shipped hyrax is read") {
    // The size of its sheet is taken from the file; the pixels do not matter here.
    const ImageDecoder blank = [](std::span<const std::byte> file) -> Result<Image> {
        const auto side = [&](std::size_t at) {
            return std::to_integer<int>(file[at]) << 8 | std::to_integer<int>(file[at + 1]);
        };
        return Image({side(18), side(22)});
    };
    const Result<SpriteSet> set =
        load_sprite_set(fs::path(HYRAX_SOURCE_DIR) / "config" / "sprites" / "hyrax", blank);
    if (!set) {
        FAIL(set.error().message);
    }
    CHECK(set->name == "hyrax");
    for (const char* known : {"idle", "fall", "held", "land", "rest", "walk"}) {
        CHECK(set->animations.contains(known));
    }
}

TEST_CASE("sprite set: the placeholder is a whole, clean set") {
    const SpriteSet set = placeholder_sprite_set("hyrax");
    CHECK(set.name == "hyrax");
    CHECK(set.sheet.size == set.cell);
    CHECK(Rect{0, 0, set.cell.width, set.cell.height}.contains(set.box));
    CHECK_FALSE(set.box.empty());
    for (const char* known : {"idle", "fall", "held", "land", "rest", "walk"}) {
        CHECK(shown(set.animation(known), 0) == CellUntil{0, never});
    }
    CHECK(is_premultiplied(set.sheet));
    const auto in_range = [&](unsigned low, unsigned high) {
        return std::ranges::count_if(set.sheet.pixels, [=](Pixel pixel) {
            return alpha_of(pixel) >= low && alpha_of(pixel) <= high;
        });
    };
    CHECK(in_range(1, 7) == 0);        // nothing that catches clicks unseen
    CHECK(in_range(8, 254) > 100);     // a soft edge
    CHECK(in_range(255, 255) > 3000);  // a body
    CHECK(alpha_of(set.sheet.at(0, 0)) == 0);
    CHECK(alpha_of(set.sheet.at(set.cell.width / 2, set.cell.height / 2)) == 255);
}
