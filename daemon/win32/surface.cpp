// SPDX-License-Identifier: MIT
#include "daemon/win32/surface.h"

#include "daemon/win32/text.h"

#include <algorithm>
#include <bit>

namespace hyrax::win32 {

namespace {

/// Powers of two: a pane that grows in steps needs few new bitmaps.
Size rounded_up(Size size, Size limit) {
    const auto side = [](int needed, int most) {
        const auto power = std::bit_ceil(static_cast<unsigned>(std::max(needed, 1)));
        return std::max(needed, std::min(static_cast<int>(power), most));
    };
    return {side(size.width, limit.width), side(size.height, limit.height)};
}

constexpr long long pixels_in(Size size) {
    return static_cast<long long>(size.width) * size.height;
}

}  // namespace

Surface::~Surface() {
    let_go();
}

void Surface::let_go() {
    if (selected_before_ != nullptr) {
        ::SelectObject(dc_.raw(), std::exchange(selected_before_, nullptr));
    }
    bitmap_.reset();
    pixels_ = nullptr;
    capacity_ = {};
}

Result<bool> Surface::make_room(Size size, Size limit) {
    const Size wanted = rounded_up(size, limit);
    const bool fits = size.width <= capacity_.width && size.height <= capacity_.height;
    if (fits && pixels_in(capacity_) <= 4 * pixels_in(wanted)) {
        return false;
    }
    let_go();
    if (!dc_) {
        dc_ = MemoryDc(::CreateCompatibleDC(nullptr));
    }
    BITMAPINFO info{};
    info.bmiHeader.biSize = sizeof info.bmiHeader;
    info.bmiHeader.biWidth = wanted.width;
    info.bmiHeader.biHeight = -wanted.height;  // Top-down.
    info.bmiHeader.biPlanes = 1;
    info.bmiHeader.biBitCount = 32;
    info.bmiHeader.biCompression = BI_RGB;
    void* bits = nullptr;
    bitmap_ = Bitmap(::CreateDIBSection(dc_.raw(), &info, DIB_RGB_COLORS, &bits, nullptr, 0));
    if (!dc_ || !bitmap_) {
        let_go();
        return std::unexpected(system_error("cannot make a bitmap for the overlay"));
    }
    selected_before_ = ::SelectObject(dc_.raw(), bitmap_.raw());
    pixels_ = static_cast<Pixel*>(bits);
    capacity_ = wanted;
    return true;
}

PixelView Surface::view(Size size) const {
    return {pixels_, capacity_.width, size};
}

}  // namespace hyrax::win32
