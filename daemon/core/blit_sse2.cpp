// SPDX-License-Identifier: MIT
// Four pixels at a time: what every x86-64 has.
#include "daemon/core/blit_rows.h"

#include <emmintrin.h>

namespace hyrax {
namespace {

constexpr int lanes = 4;

__m128i load(const Pixel* from) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
}

void store(Pixel* to, __m128i pixels) {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to), pixels);
}

bool all_clear(__m128i pixels) {
    return _mm_movemask_epi8(_mm_cmpeq_epi32(pixels, _mm_setzero_si128())) == 0xFFFF;
}

bool all_opaque(__m128i pixels) {
    const __m128i opaque = _mm_set1_epi32(-0x01000000);  // Alpha 255 in each pixel.
    const __m128i is_opaque = _mm_cmpeq_epi32(_mm_and_si128(pixels, opaque), opaque);
    return _mm_movemask_epi8(is_opaque) == 0xFFFF;
}

// 16-bit channels times 16-bit factors / 255, rounded as the reference does.
__m128i times(__m128i channels, __m128i factors) {
    const __m128i v = _mm_add_epi16(_mm_mullo_epi16(channels, factors), _mm_set1_epi16(128));
    return _mm_srli_epi16(_mm_add_epi16(v, _mm_srli_epi16(v, 8)), 8);
}

// The alpha of each pixel in all four of its lanes.
__m128i alphas(__m128i channels) {
    return _mm_shufflehi_epi16(_mm_shufflelo_epi16(channels, 0xFF), 0xFF);
}

__m128i source_over(__m128i source, __m128i target) {
    const __m128i zero = _mm_setzero_si128();
    const __m128i full = _mm_set1_epi16(255);
    const __m128i low = _mm_sub_epi16(full, alphas(_mm_unpacklo_epi8(source, zero)));
    const __m128i high = _mm_sub_epi16(full, alphas(_mm_unpackhi_epi8(source, zero)));
    const __m128i under = _mm_packus_epi16(
        times(_mm_unpacklo_epi8(target, zero), low), times(_mm_unpackhi_epi8(target, zero), high)
    );
    return _mm_add_epi32(source, under);
}

// What a width leaves over is drawn with the last four pixels of its row, without those that have
// been drawn already: nothing changes below clear ones.
__m128i undrawn(int width) {
    return _mm_cmpgt_epi32(_mm_setr_epi32(0, 1, 2, 3), _mm_set1_epi32(lanes - 1 - width % lanes));
}

__m128i faded(__m128i pixels, unsigned opacity) {
    const __m128i zero = _mm_setzero_si128();
    const __m128i factor = _mm_set1_epi16(static_cast<short>(opacity));
    return _mm_packus_epi16(
        times(_mm_unpacklo_epi8(pixels, zero), factor),
        times(_mm_unpackhi_epi8(pixels, zero), factor)
    );
}

void draw(Pixel* to, __m128i source) {
    if (!all_clear(source)) {
        store(to, source_over(source, load(to)));
    }
}

void draw_faded(Pixel* to, __m128i source, unsigned opacity) {
    if (!all_clear(source)) {
        store(to, source_over(faded(source, opacity), load(to)));
    }
}

}  // namespace

void blend_sse2(Rows rows) {
    if (rows.width < lanes) {
        return blend_scalar(rows);
    }
    const int last = rows.width - lanes;
    const __m128i left_over = undrawn(rows.width);
    for (; rows.count > 0; rows.next()) {
        int i = 0;
        // Mostly they are all clear or all opaque: two tests for eight pixels, not for four.
        for (; i <= last - lanes; i += 2 * lanes) {
            const __m128i first = load(rows.from + i);
            const __m128i second = load(rows.from + i + lanes);
            if (all_clear(_mm_or_si128(first, second))) {
                continue;
            }
            Pixel* const to = rows.to + i;
            if (all_opaque(_mm_and_si128(first, second))) {
                store(to, first);
                store(to + lanes, second);
            } else {
                store(to, source_over(first, load(to)));
                store(to + lanes, source_over(second, load(to + lanes)));
            }
        }
        if (i <= last) {
            draw(rows.to + i, load(rows.from + i));
        }
        draw(rows.to + last, _mm_and_si128(load(rows.from + last), left_over));
    }
}

void blend_faded_sse2(Rows rows, unsigned opacity) {
    if (rows.width < lanes) {
        return blend_faded_scalar(rows, opacity);
    }
    const int last = rows.width - lanes;
    const __m128i left_over = undrawn(rows.width);
    for (; rows.count > 0; rows.next()) {
        for (int i = 0; i <= last; i += lanes) {
            draw_faded(rows.to + i, load(rows.from + i), opacity);
        }
        draw_faded(rows.to + last, _mm_and_si128(load(rows.from + last), left_over), opacity);
    }
}

}  // namespace hyrax
