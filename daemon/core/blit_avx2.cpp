// SPDX-License-Identifier: MIT
// Eight pixels at a time. Attributes and unaligned accesses: for the reasons that
// physics/batch_avx2.cpp gives. Only to what is inlined are vectors passed.
#include "daemon/core/blit_rows.h"

#include <immintrin.h>

namespace hyrax {
namespace {

constexpr int lanes = 8;

[[gnu::target("avx2"), gnu::always_inline]] inline __m256i load(const Pixel* from) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
}

[[gnu::target("avx2"), gnu::always_inline]] inline void store(Pixel* to, __m256i pixels) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), pixels);
}

[[gnu::target("avx2"), gnu::always_inline]] inline bool all_clear(__m256i pixels) {
    return _mm256_testz_si256(pixels, pixels) != 0;
}

[[gnu::target("avx2"), gnu::always_inline]] inline bool all_opaque(__m256i pixels) {
    const __m256i opaque = _mm256_set1_epi32(-0x01000000);  // Alpha 255 in each pixel.
    return _mm256_testc_si256(pixels, opaque) != 0;
}

// 16-bit channels times 16-bit factors / 255, rounded as the reference does.
[[gnu::target("avx2"), gnu::always_inline]] inline __m256i times(
    __m256i channels, __m256i factors
) {
    const __m256i v =
        _mm256_add_epi16(_mm256_mullo_epi16(channels, factors), _mm256_set1_epi16(128));
    return _mm256_srli_epi16(_mm256_add_epi16(v, _mm256_srli_epi16(v, 8)), 8);
}

// 255 less the alpha of each pixel, in all four of its lanes.
[[gnu::target("avx2"), gnu::always_inline]] inline __m256i transparency(__m256i channels) {
    const __m256i alphas = _mm256_shufflehi_epi16(_mm256_shufflelo_epi16(channels, 0xFF), 0xFF);
    return _mm256_sub_epi16(_mm256_set1_epi16(255), alphas);
}

// One channel to each 16-bit lane: of pixels 0, 1, 4, 5 and of 2, 3, 6, 7. Packing undoes it.
[[gnu::target("avx2"), gnu::always_inline]] inline __m256i low_half(__m256i pixels) {
    return _mm256_unpacklo_epi8(pixels, _mm256_setzero_si256());
}

[[gnu::target("avx2"), gnu::always_inline]] inline __m256i high_half(__m256i pixels) {
    return _mm256_unpackhi_epi8(pixels, _mm256_setzero_si256());
}

// `low` and `high` are the halves of the source.
[[gnu::target("avx2"), gnu::always_inline]] inline void source_over(
    Pixel* to, __m256i source, __m256i low, __m256i high
) {
    const __m256i target = load(to);
    const __m256i under = _mm256_packus_epi16(
        times(low_half(target), transparency(low)), times(high_half(target), transparency(high))
    );
    store(to, _mm256_add_epi32(source, under));
}

[[gnu::target("avx2"), gnu::always_inline]] inline void draw(Pixel* to, __m256i source) {
    source_over(to, source, low_half(source), high_half(source));
}

[[gnu::target("avx2"), gnu::always_inline]] inline void draw_faded(
    Pixel* to, __m256i source, unsigned opacity
) {
    if (!all_clear(source)) {
        const __m256i factor = _mm256_set1_epi16(static_cast<short>(opacity));
        const __m256i low = times(low_half(source), factor);
        const __m256i high = times(high_half(source), factor);
        source_over(to, _mm256_packus_epi16(low, high), low, high);
    }
}

// As in blit_sse2.cpp.
[[gnu::target("avx2"), gnu::always_inline]] inline __m256i undrawn(int width) {
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    return _mm256_cmpgt_epi32(lane, _mm256_set1_epi32(lanes - 1 - width % lanes));
}

}  // namespace

[[gnu::target("avx2")]] void blend_avx2(Rows rows) {
    if (rows.width < lanes) {
        return blend_sse2(rows);
    }
    const int last = rows.width - lanes;
    const __m256i left_over = undrawn(rows.width);
    for (; rows.count > 0; rows.next()) {
        for (int i = 0; i <= last; i += lanes) {
            const __m256i source = load(rows.from + i);
            if (all_clear(source)) {
                continue;
            }
            if (all_opaque(source)) {
                store(rows.to + i, source);
            } else {
                draw(rows.to + i, source);
            }
        }
        const __m256i source = _mm256_and_si256(load(rows.from + last), left_over);
        if (!all_clear(source)) {
            draw(rows.to + last, source);
        }
    }
}

[[gnu::target("avx2")]] void blend_faded_avx2(Rows rows, unsigned opacity) {
    if (rows.width < lanes) {
        return blend_faded_sse2(rows, opacity);
    }
    const int last = rows.width - lanes;
    const __m256i left_over = undrawn(rows.width);
    for (; rows.count > 0; rows.next()) {
        for (int i = 0; i <= last; i += lanes) {
            draw_faded(rows.to + i, load(rows.from + i), opacity);
        }
        draw_faded(rows.to + last, _mm256_and_si256(load(rows.from + last), left_over), opacity);
    }
}

}  // namespace hyrax
