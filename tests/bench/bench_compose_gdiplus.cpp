// SPDX-License-Identifier: MIT
#include "daemon/win32/gdiplus_renderer.h"
#include "daemon/win32/image_decoder.h"
#include "tests/bench/bench_compose.h"

namespace hyrax::bench {

Composer gdiplus_composer() {
    return [](const PixelView& target, const Frame& frame) {
        static const win32::GdiplusSession session;
        const Rect whole{0, 0, target.size.width, target.size.height};
        win32::compose_with_gdiplus(target, {}, whole, frame);
    };
}

}  // namespace hyrax::bench
