// SPDX-License-Identifier: MIT
#include "daemon/core/png_header.h"

#include <doctest/doctest.h>

#include <string>

using namespace hyrax;

namespace {

std::string png(const std::string& size) {
    return std::string("\x89PNG\r\n\x1A\n\0\0\0\x0DIHDR", 16) + size;
}

std::optional<Size> size_in(const std::string& text) {
    return png_size(std::as_bytes(std::span(text)));
}

}  // namespace

TEST_CASE("the size is read from the header") {
    CHECK(size_in(png(std::string("\0\0\3\0\0\0\2\1", 8))) == Size{768, 513});
}

TEST_CASE("a size beyond an int is the largest int") {
    CHECK(
        size_in(png("\xFF\xFF\xFF\xFF\x80" + std::string(3, '\0'))) == Size{0x7FFFFFFF, 0x7FFFFFFF}
    );
}

TEST_CASE("what is no PNG file has no size") {
    CHECK_FALSE(size_in(""));
    CHECK_FALSE(size_in(png("")));
    CHECK_FALSE(size_in("GIF89a and then some more bytes"));
}
