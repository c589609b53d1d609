// SPDX-License-Identifier: MIT
#include "daemon/win32/gdiplus_renderer.h"

#include "daemon/win32/gdiplus_include.h"

namespace hyrax::win32 {

namespace {

constexpr int bytes_per_pixel = sizeof(Pixel);

/// All channels of premultiplied pixels times a share: GDI+ multiplies straight ones, whose colour
/// stays.
void set_opacity(Gdiplus::ImageAttributes& attributes, std::uint8_t opacity) {
    Gdiplus::ColorMatrix matrix{};
    for (int i = 0; i < 5; ++i) {
        matrix.m[i][i] = 1.0F;
    }
    matrix.m[3][3] = static_cast<float>(opacity) / 255.0F;
    attributes.SetColorMatrix(&matrix);
}

void draw(Gdiplus::Graphics& graphics, const Sprite& sprite, Point at) {
    const Image& image = *sprite.image;
    const Size size = image.size;
    // GDI+ takes the address without const, and only reads from it.
    auto* const pixels = reinterpret_cast<BYTE*>(const_cast<Pixel*>(image.pixels.data()));
    Gdiplus::Bitmap bitmap(
        size.width, size.height, size.width * bytes_per_pixel, PixelFormat32bppPARGB, pixels
    );
    Gdiplus::ImageAttributes attributes;
    if (sprite.opacity != 255) {
        set_opacity(attributes, sprite.opacity);
    }
    // With both rectangles in pixels: else the picture's resolution scales it.
    graphics.DrawImage(
        &bitmap,
        Gdiplus::Rect(at.x, at.y, size.width, size.height),
        0,
        0,
        size.width,
        size.height,
        Gdiplus::UnitPixel,
        sprite.opacity != 255 ? &attributes : nullptr
    );
}

}  // namespace

void compose_with_gdiplus(
    const PixelView& target, Point origin, const Rect& area, const Frame& frame
) {
    const Rect whole{0, 0, target.size.width, target.size.height};
    const Rect local =
        intersection({area.x - origin.x, area.y - origin.y, area.width, area.height}, whole);
    if (local.empty()) {
        return;
    }
    Gdiplus::Bitmap bitmap(
        target.size.width,
        target.size.height,
        target.stride * bytes_per_pixel,
        PixelFormat32bppPARGB,
        reinterpret_cast<BYTE*>(target.pixels)
    );
    Gdiplus::Graphics graphics(&bitmap);
    graphics.SetClip(Gdiplus::Rect(local.x, local.y, local.width, local.height));
    graphics.SetInterpolationMode(Gdiplus::InterpolationModeNearestNeighbor);
    graphics.SetPixelOffsetMode(Gdiplus::PixelOffsetModeHalf);
    // Replaces what is there: a transparent colour over it would change nothing.
    const Gdiplus::SolidBrush clear(Gdiplus::Color(0, 0, 0, 0));
    graphics.SetCompositingMode(Gdiplus::CompositingModeSourceCopy);
    graphics.FillRectangle(&clear, local.x, local.y, local.width, local.height);
    graphics.SetCompositingMode(Gdiplus::CompositingModeSourceOver);
    for (const Sprite& sprite : frame.sprites) {
        if (!intersection(sprite.bounds(), area).empty()) {
            draw(graphics, sprite, {sprite.at.x - origin.x, sprite.at.y - origin.y});
        }
    }
    graphics.Flush(Gdiplus::FlushIntentionSync);
}

}  // namespace hyrax::win32
