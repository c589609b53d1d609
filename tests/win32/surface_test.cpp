// SPDX-License-Identifier: MIT
#include "daemon/win32/surface.h"

#include <doctest/doctest.h>

using namespace hyrax;
using hyrax::win32::Surface;

TEST_CASE("a surface is made anew only when it must be") {
    constexpr Size screen{1920, 1080};
    Surface surface;
    CHECK(surface.make_room({300, 200}, screen) == true);
    CHECK(surface.make_room({512, 256}, screen) == false);
    CHECK(surface.make_room({130, 130}, screen) == false);
    CHECK(surface.make_room({513, 256}, screen) == true);
    CHECK(surface.make_room(screen, screen) == true);
    CHECK(surface.view(screen).stride == 1920);
    // Memory for a whole screen is not kept for a single pet.
    CHECK(surface.make_room({128, 128}, screen) == true);
}

TEST_CASE("pixels written are the pixels that the system has") {
    Surface surface;
    REQUIRE(surface.make_room({64, 64}, {64, 64}));
    const PixelView view = surface.view({64, 64});
    view.pixels[5 * view.stride + 7] = 0xFF112233;
    ::GdiFlush();
    CHECK(::GetPixel(surface.dc(), 7, 5) == RGB(0x11, 0x22, 0x33));
}
