// SPDX-License-Identifier: MIT
#include "daemon/win32/text_painter.h"

#include "daemon/win32/surface.h"
#include "daemon/win32/text.h"

#include <algorithm>

namespace hyrax::win32 {

namespace {

using Font = Handle<HFONT, ::DeleteObject>;

constexpr int text_height = 14;  // [px]
constexpr Size longest_line{4096, 64};

// Selects an object for as long as it lives.
class Selected {
public:
    Selected(HDC dc, HGDIOBJ object) : dc_(dc), before_(::SelectObject(dc, object)) {}
    Selected(const Selected&) = delete;
    Selected& operator=(const Selected&) = delete;
    ~Selected() { ::SelectObject(dc_, before_); }

private:
    HDC dc_;
    HGDIOBJ before_;
};

Font font_for_texts() {
    LOGFONTW wanted{};
    wanted.lfHeight = -text_height;
    wanted.lfWeight = FW_NORMAL;
    wanted.lfCharSet = DEFAULT_CHARSET;
    wanted.lfQuality = ANTIALIASED_QUALITY;  // ClearType's coloured edges have no single alpha.
    std::ranges::copy(std::wstring_view(L"Segoe UI"), wanted.lfFaceName);
    return Font(::CreateFontIndirectW(&wanted));
}

Result<Size> measured(HDC dc, const std::wstring& text) {
    TEXTMETRICW metrics{};
    SIZE extent{};
    if (::GetTextMetricsW(dc, &metrics) == FALSE ||
        ::GetTextExtentPoint32W(dc, text.c_str(), static_cast<int>(text.size()), &extent) ==
            FALSE) {
        return std::unexpected(system_error("cannot measure a text"));
    }
    return Size{
        std::clamp(static_cast<int>(extent.cx), 1, longest_line.width),
        std::clamp(static_cast<int>(metrics.tmHeight), 1, longest_line.height),
    };
}

// White on black: what is white there is how much of the pixel the text covers.
Result<Image> draw_line(std::string_view line) {
    const std::wstring text = wide(line);
    const Font font = font_for_texts();
    Surface surface;
    if (const Result<bool> room = surface.make_room({1, 1}, longest_line); !room) {
        return std::unexpected(room.error());
    }
    Result<Size> size = Size{};
    {
        const Selected selected(surface.dc(), font.raw());
        size = measured(surface.dc(), text);
    }
    if (!size) {
        return std::unexpected(size.error());
    }
    if (const Result<bool> room = surface.make_room(*size, longest_line); !room) {
        return std::unexpected(room.error());
    }
    const PixelView drawn = surface.view(*size);
    erase(drawn, {0, 0, size->width, size->height});
    const Selected selected(surface.dc(), font.raw());
    ::SetTextColor(surface.dc(), RGB(255, 255, 255));
    ::SetBkMode(surface.dc(), TRANSPARENT);
    if (::ExtTextOutW(
            surface.dc(), 0, 0, 0, nullptr, text.c_str(), static_cast<UINT>(text.size()), nullptr
        ) == FALSE) {
        return std::unexpected(system_error("cannot draw a text"));
    }
    ::GdiFlush();
    Image image(*size);
    for (int y = 0; y < size->height; ++y) {
        for (int x = 0; x < size->width; ++x) {
            const Pixel white = drawn.pixels[static_cast<std::ptrdiff_t>(y) * drawn.stride + x];
            image.at(x, y) = ((white >> 8U) & 0xFFU) << 24U;
        }
    }
    return image;
}

}  // namespace

TextPainter make_text_painter() {
    return draw_line;
}

}  // namespace hyrax::win32
