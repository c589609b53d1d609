// SPDX-License-Identifier: MIT
// GDI+ as the decoder of pictures.
#pragma once

#include "daemon/core/image.h"

#include <windows.h>

namespace hyrax::win32 {

/// GDI+ for the whole process. Must outlive every object of GDI+.
class GdiplusSession {
public:
    GdiplusSession();
    GdiplusSession(const GdiplusSession&) = delete;
    GdiplusSession& operator=(const GdiplusSession&) = delete;
    ~GdiplusSession();

    bool started() const { return started_; }

private:
    ULONG_PTR token_ = 0;
    bool started_ = false;
};

/// Needs a GdiplusSession while it is called; may be called on any one thread at a time.
ImageDecoder make_gdiplus_decoder();

}  // namespace hyrax::win32
