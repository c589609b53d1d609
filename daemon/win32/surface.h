// SPDX-License-Identifier: MIT
// Pixels that the system can show: a bitmap in memory, selected into its own device context.
#pragma once

#include "daemon/core/blit.h"
#include "daemon/core/result.h"
#include "daemon/win32/handle.h"
#include "physics/geometry.h"

namespace hyrax::win32 {

/// Kept for as long as it fits; made anew only when a size asks for it, never for a frame.
class Surface {
public:
    Surface() = default;
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;
    ~Surface();

    /// Makes room for this size, which will not exceed `limit`. True if the old pixels are gone.
    [[nodiscard]] Result<bool> make_room(Size size, Size limit);

    /// Gives the memory back.
    void let_go();

    /// The top-left part of this size; must fit.
    PixelView view(Size size) const;
    HDC dc() const { return dc_.raw(); }

private:
    // In order of dependence. A bitmap cannot be deleted while a context has it selected.
    Bitmap bitmap_;
    MemoryDc dc_;
    HGDIOBJ selected_before_ = nullptr;
    Pixel* pixels_ = nullptr;
    Size capacity_;
};

}  // namespace hyrax::win32
