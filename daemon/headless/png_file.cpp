// SPDX-License-Identifier: MIT
#include "daemon/headless/png_file.h"

#include <fmt/format.h>
#include <png.h>

#include <vector>

namespace hyrax {
namespace {

// libpng's simplified interface keeps its state here and must be told when it is no longer needed.
class PngImage {
public:
    PngImage() { image_.version = PNG_IMAGE_VERSION; }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;
    ~PngImage() { ::png_image_free(&image_); }

    png_image* get() { return &image_; }
    png_image* operator->() { return &image_; }

private:
    png_image image_{};
};

constexpr Pixel channel(unsigned value, unsigned shift) {
    return value << shift;
}

Pixel premultiplied(Pixel straight) {
    const unsigned alpha = alpha_of(straight);
    const auto scaled = [alpha, straight](unsigned shift) {
        return channel((((straight >> shift) & 0xffU) * alpha + 127U) / 255U, shift);
    };
    return channel(alpha, 24) | scaled(16) | scaled(8) | scaled(0);
}

Pixel straight(Pixel premultiplied_pixel) {
    const unsigned alpha = alpha_of(premultiplied_pixel);
    if (alpha == 0) {
        return 0;
    }
    const auto scaled = [alpha, premultiplied_pixel](unsigned shift) {
        return channel(
            (((premultiplied_pixel >> shift) & 0xffU) * 255U + alpha / 2U) / alpha, shift
        );
    };
    return channel(alpha, 24) | scaled(16) | scaled(8) | scaled(0);
}

}  // namespace

Result<Image> decode_png(std::span<const std::byte> file) {
    PngImage png;
    if (::png_image_begin_read_from_memory(png.get(), file.data(), file.size()) == 0) {
        return failure(fmt::format("not a readable PNG: {}", png->message));
    }
    constexpr auto limit = static_cast<png_uint_32>(max_image_side);
    if (png->width == 0 || png->height == 0 || png->width > limit || png->height > limit) {
        return failure(fmt::format(
            "the picture is {} x {} pixels; at most {} x {} are allowed",
            png->width,
            png->height,
            limit,
            limit
        ));
    }
    png->format = PNG_FORMAT_BGRA;
    Image image(Size{static_cast<int>(png->width), static_cast<int>(png->height)});
    if (::png_image_finish_read(png.get(), nullptr, image.pixels.data(), 0, nullptr) == 0) {
        return failure(fmt::format("not a readable PNG: {}", png->message));
    }
    for (Pixel& pixel : image.pixels) {
        pixel = premultiplied(pixel);
    }
    return image;
}

Result<void> write_png(const std::filesystem::path& path, const Image& image) {
    std::vector<Pixel> pixels;
    pixels.reserve(image.pixels.size());
    for (const Pixel pixel : image.pixels) {
        pixels.push_back(straight(pixel));
    }
    PngImage png;
    png->width = static_cast<png_uint_32>(image.size.width);
    png->height = static_cast<png_uint_32>(image.size.height);
    png->format = PNG_FORMAT_BGRA;
    if (::png_image_write_to_file(png.get(), path.c_str(), 0, pixels.data(), 0, nullptr) == 0) {
        return failure(fmt::format("{}: cannot be written: {}", path.string(), png->message));
    }
    return {};
}

}  // namespace hyrax
