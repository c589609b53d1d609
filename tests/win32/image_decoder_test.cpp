// SPDX-License-Identifier: MIT
#include "daemon/win32/image_decoder.h"

#include "daemon/core/files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace hyrax;
using namespace hyrax::win32;

namespace {

std::vector<std::byte> shipped_sheet() {
    auto file = read_binary_file(
        path_from_utf8(HYRAX_SOURCE_DIR "/config/sprites/hyrax/sheet.png"), max_image_file_bytes
    );
    REQUIRE(file);
    return *std::move(file);
}

bool is_premultiplied(Pixel pixel) {
    const unsigned alpha = alpha_of(pixel);
    return ((pixel >> 16U) & 0xFFU) <= alpha && ((pixel >> 8U) & 0xFFU) <= alpha &&
           (pixel & 0xFFU) <= alpha;
}

}  // namespace

TEST_CASE("the shipped sheet is decoded into premultiplied pixels") {
    const GdiplusSession session;
    REQUIRE(session.started());
    const Result<Image> image = make_gdiplus_decoder()(shipped_sheet());
    REQUIRE(image);
    CHECK(image->size.width % 128 == 0);
    CHECK(std::ranges::all_of(image->pixels, is_premultiplied));
    CHECK(std::ranges::count_if(image->pixels, [](Pixel pixel) {
              return alpha_of(pixel) == 255;
          }) > 10'000);
    CHECK(alpha_of(image->at(0, 0)) == 0);
}

TEST_CASE("damaged and huge pictures are refused with a reason") {
    const GdiplusSession session;
    const ImageDecoder decode = make_gdiplus_decoder();
    std::vector<std::byte> file = shipped_sheet();

    CHECK(decode({}).error().message == "not a PNG file");
    CHECK(
        decode(std::vector<std::byte>(max_image_file_bytes + 1)).error().message.contains("16 MiB")
    );

    const std::span<const std::byte> header_alone(file.data(), 40);
    CHECK(decode(header_alone).error().message.contains("damaged"));

    file[16] = std::byte{0x7F};  // The width's first byte.
    CHECK(decode(file).error().message.contains("allowed are 1 to 8192"));
}
