// SPDX-License-Identifier: MIT
#include "daemon/win32/text_painter.h"

#include "daemon/win32/gdiplus_include.h"
#include "daemon/win32/text.h"

#include <algorithm>
#include <cmath>

namespace hyrax::win32 {

namespace {

constexpr Gdiplus::REAL text_height = 14;  // [px]

Result<Image> draw_line(std::string_view line) {
    const std::wstring text = wide(line);
    const auto length = static_cast<INT>(text.size());
    const Gdiplus::FontFamily segoe(L"Segoe UI");
    const Gdiplus::FontFamily* const family =
        segoe.IsAvailable() != FALSE ? &segoe : Gdiplus::FontFamily::GenericSansSerif();
    const Gdiplus::Font font(family, text_height, Gdiplus::FontStyleRegular, Gdiplus::UnitPixel);
    if (font.GetLastStatus() != Gdiplus::Ok) {
        return failure("there is no font for texts");
    }
    // Without it a line is measured as wider than it is drawn, and blanks at its end do not count.
    Gdiplus::StringFormat format(Gdiplus::StringFormat::GenericTypographic());
    format.SetFormatFlags(
        format.GetFormatFlags() | Gdiplus::StringFormatFlagsMeasureTrailingSpaces
    );

    Gdiplus::Bitmap measured_on(1, 1, PixelFormat32bppPARGB);
    const Gdiplus::Graphics measure(&measured_on);
    Gdiplus::RectF bounds;
    if (measure.MeasureString(text.c_str(), length, &font, {0, 0}, &format, &bounds) !=
        Gdiplus::Ok) {
        return failure("a text cannot be measured");
    }
    Image image(Size{
        std::max(1, static_cast<int>(std::ceil(bounds.Width))),
        std::max(1, static_cast<int>(std::ceil(font.GetHeight(&measure))))
    });
    Gdiplus::Bitmap bitmap(
        image.size.width,
        image.size.height,
        image.size.width * static_cast<INT>(sizeof(Pixel)),
        PixelFormat32bppPARGB,
        reinterpret_cast<BYTE*>(image.pixels.data())
    );
    Gdiplus::Graphics graphics(&bitmap);
    // ClearType would colour the edges, which premultiplied pixels cannot keep.
    graphics.SetTextRenderingHint(Gdiplus::TextRenderingHintAntiAliasGridFit);
    const Gdiplus::SolidBrush black(Gdiplus::Color(255, 0, 0, 0));
    if (graphics.DrawString(text.c_str(), length, &font, {0, 0}, &format, &black) != Gdiplus::Ok) {
        return failure("a text cannot be drawn");
    }
    graphics.Flush(Gdiplus::FlushIntentionSync);
    return image;
}

}  // namespace

TextPainter make_gdiplus_text_painter() {
    return draw_line;
}

}  // namespace hyrax::win32
