// SPDX-License-Identifier: MIT
#include "daemon/headless/text_painter.h"

#include <freetype/freetype.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace hyrax {
namespace {

constexpr unsigned text_height = 14;  // [px]
constexpr const char* font_file = HYRAX_FONT;

// The next character of UTF-8 that is known to be valid; U+FFFD for what is not.
char32_t take_character(std::string_view& text) {
    const auto byte = [&text](std::size_t i) {
        return i < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[i])) : 0U;
    };
    const unsigned first = byte(0);
    const std::size_t length = first < 0x80U ? 1 : first < 0xE0U ? 2 : first < 0xF0U ? 3 : 4;
    if (first >= 0x80U && first < 0xC0U) {
        text.remove_prefix(1);
        return U'\uFFFD';
    }
    char32_t character = length == 1 ? first : first & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        character = character << 6U | (byte(i) & 0x3FU);
    }
    text.remove_prefix(std::min(length, text.size()));
    return character;
}

// Pixels of a picture come from 26.6 numbers.
int pixels(FT_Pos position) {
    return static_cast<int>((position + 63) >> 6);
}

void copy(const FT_GlyphSlotRec& glyph, int pen, int baseline, Image& image) {
    for (unsigned row = 0; row < glyph.bitmap.rows; ++row) {
        for (unsigned column = 0; column < glyph.bitmap.width; ++column) {
            const int x = pen + glyph.bitmap_left + static_cast<int>(column);
            const int y = baseline - glyph.bitmap_top + static_cast<int>(row);
            if (x < 0 || y < 0 || x >= image.size.width || y >= image.size.height) {
                continue;
            }
            const std::ptrdiff_t offset = std::ptrdiff_t{glyph.bitmap.pitch} * row + column;
            const Pixel cover = glyph.bitmap.buffer[offset];
            Pixel& pixel = image.at(x, y);
            pixel = std::max(alpha_of(pixel), cover) << 24U;
        }
    }
}

}  // namespace

void FreetypePainter::EndLibrary::operator()(FT_LibraryRec_* library) const {
    FT_Done_FreeType(library);
}

void FreetypePainter::EndFace::operator()(FT_FaceRec_* face) const {
    FT_Done_Face(face);
}

FreetypePainter::FreetypePainter() {
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) {
        return;
    }
    library_.reset(library);
    FT_Face face = nullptr;
    if (FT_New_Face(library, font_file, 0, &face) != 0) {
        return;
    }
    face_.reset(face);
    if (FT_Set_Pixel_Sizes(face, 0, text_height) != 0) {
        face_.reset();
    }
}

Result<Image> FreetypePainter::draw(std::string_view line) const {
    if (!face_) {
        return failure(std::string("no font \"") + font_file + "\"");
    }
    FT_FaceRec_& face = *face_;
    const auto load = [&face](std::string_view& rest, FT_Int32 flags) {
        return FT_Load_Char(&face, take_character(rest), flags) == 0;
    };
    FT_Pos width = 0;
    for (std::string_view rest = line; !rest.empty();) {
        width += load(rest, FT_LOAD_DEFAULT) ? face.glyph->advance.x : 0;
    }
    Image image(Size{std::max(1, pixels(width)), pixels(face.size->metrics.height)});
    const int baseline = pixels(face.size->metrics.ascender);
    FT_Pos pen = 0;
    for (std::string_view rest = line; !rest.empty();) {
        if (load(rest, FT_LOAD_RENDER)) {
            copy(*face.glyph, static_cast<int>(pen >> 6), baseline, image);
            pen += face.glyph->advance.x;
        }
    }
    return image;
}

}  // namespace hyrax
