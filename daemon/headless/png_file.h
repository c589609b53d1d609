// SPDX-License-Identifier: MIT
// PNG by libpng.
#pragma once

#include "daemon/core/image.h"
#include "daemon/core/result.h"

#include <filesystem>

namespace hyrax {

/// Sizes beyond the limits of image.h are refused before anything is decoded.
[[nodiscard]] Result<Image> decode_png(std::span<const std::byte> file);

/// Writes straight alpha, as PNG wants it.
[[nodiscard]] Result<void> write_png(const std::filesystem::path& path, const Image& image);

}  // namespace hyrax
