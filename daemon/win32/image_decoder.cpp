// SPDX-License-Identifier: MIT
#include "daemon/win32/image_decoder.h"

#include "daemon/core/png_header.h"
#include "daemon/win32/gdiplus_include.h"
#include "daemon/win32/handle.h"

#include <string>

namespace hyrax::win32 {

namespace {

/// A stream over a copy of the bytes; freed with the stream.
ComPointer<IStream> memory_stream(std::span<const std::byte> bytes) {
    IStream* stream = nullptr;
    if (FAILED(::CreateStreamOnHGlobal(nullptr, TRUE, &stream))) {
        return nullptr;
    }
    ComPointer<IStream> owner(stream);
    ULONG written = 0;
    const auto size = static_cast<ULONG>(bytes.size());
    if (FAILED(stream->Write(bytes.data(), size, &written)) || written != size) {
        return nullptr;
    }
    const LARGE_INTEGER start{};
    return SUCCEEDED(stream->Seek(start, STREAM_SEEK_SET, nullptr)) ? std::move(owner) : nullptr;
}

/// Lets GDI+ write premultiplied pixels right into the image.
bool copy_pixels(Gdiplus::Bitmap& bitmap, Image& image) {
    const Gdiplus::Rect all(0, 0, image.size.width, image.size.height);
    Gdiplus::BitmapData data{};
    data.Width = static_cast<UINT>(image.size.width);
    data.Height = static_cast<UINT>(image.size.height);
    data.Stride = image.size.width * static_cast<INT>(sizeof(Pixel));
    data.PixelFormat = PixelFormat32bppPARGB;
    data.Scan0 = image.pixels.data();
    constexpr UINT mode = Gdiplus::ImageLockModeRead | Gdiplus::ImageLockModeUserInputBuf;
    return bitmap.LockBits(&all, mode, PixelFormat32bppPARGB, &data) == Gdiplus::Ok &&
           bitmap.UnlockBits(&data) == Gdiplus::Ok;
}

Result<Image> decode(std::span<const std::byte> file) {
    if (file.size() > max_image_file_bytes) {
        return failure(
            "the file is larger than " + std::to_string(max_image_file_bytes >> 20U) + " MiB"
        );
    }
    const std::optional<Size> size = png_size(file);
    if (!size) {
        return failure("not a PNG file");
    }
    if (size->width < 1 || size->height < 1 || size->width > max_image_side ||
        size->height > max_image_side) {
        return failure(
            "the picture has " + std::to_string(size->width) + "x" + std::to_string(size->height) +
            " pixels; allowed are 1 to " + std::to_string(max_image_side) + " on each side"
        );
    }
    // GDI+ reads from the stream until the bitmap is gone.
    const ComPointer<IStream> stream = memory_stream(file);
    if (!stream) {
        return failure("out of memory");
    }
    Gdiplus::Bitmap bitmap(stream.get(), FALSE);
    if (bitmap.GetLastStatus() != Gdiplus::Ok ||
        bitmap.GetWidth() != static_cast<UINT>(size->width) ||
        bitmap.GetHeight() != static_cast<UINT>(size->height)) {
        return failure("the PNG file is damaged");
    }
    Image image(*size);
    if (!copy_pixels(bitmap, image)) {
        return failure("the PNG file is damaged");
    }
    return image;
}

}  // namespace

GdiplusSession::GdiplusSession() {
    const Gdiplus::GdiplusStartupInput input;
    started_ = Gdiplus::GdiplusStartup(&token_, &input, nullptr) == Gdiplus::Ok;
}

GdiplusSession::~GdiplusSession() {
    if (started_) {
        Gdiplus::GdiplusShutdown(token_);
    }
}

ImageDecoder make_gdiplus_decoder() {
    return decode;
}

}  // namespace hyrax::win32
