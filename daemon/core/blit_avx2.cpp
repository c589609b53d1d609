// SPDX-License-Identifier: MIT
// Eight pixels at a time. Attributes, unaligned accesses and vectors that are never passed by
// value: for the reasons that physics/batch_avx2.cpp gives.
#include "daemon/core/blit_rows.h"

#include <immintrin.h>

namespace hyrax {

[[gnu::target("avx2")]] void blend_avx2(Pixel* to, const Pixel* from, int count) {
    constexpr int lanes = 8;
    const __m256i zero = _mm256_setzero_si256();
    const __m256i opaque = _mm256_set1_epi32(-0x01000000);  // Alpha 255 in each pixel.
    const __m256i full = _mm256_set1_epi16(255);
    const __m256i half = _mm256_set1_epi16(128);
    int i = 0;
    for (; i + lanes <= count; i += lanes) {
        const __m256i source = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from + i));
        if (_mm256_testz_si256(source, source) != 0) {
            continue;
        }
        auto* const place = reinterpret_cast<__m256i*>(to + i);
        if (_mm256_testc_si256(source, opaque) != 0) {
            _mm256_storeu_si256(place, source);
            continue;
        }
        const __m256i target = _mm256_loadu_si256(place);
        // Pixels 0, 1, 4, 5 and 2, 3, 6, 7, one channel to each 16-bit lane; packing undoes it.
        __m256i low = _mm256_unpacklo_epi8(source, zero);
        __m256i high = _mm256_unpackhi_epi8(source, zero);
        low = _mm256_shufflehi_epi16(_mm256_shufflelo_epi16(low, 0xFF), 0xFF);
        high = _mm256_shufflehi_epi16(_mm256_shufflelo_epi16(high, 0xFF), 0xFF);
        low = _mm256_mullo_epi16(_mm256_unpacklo_epi8(target, zero), _mm256_sub_epi16(full, low));
        high = _mm256_mullo_epi16(_mm256_unpackhi_epi8(target, zero), _mm256_sub_epi16(full, high));
        low = _mm256_add_epi16(low, half);
        high = _mm256_add_epi16(high, half);
        low = _mm256_srli_epi16(_mm256_add_epi16(low, _mm256_srli_epi16(low, 8)), 8);
        high = _mm256_srli_epi16(_mm256_add_epi16(high, _mm256_srli_epi16(high, 8)), 8);
        _mm256_storeu_si256(place, _mm256_add_epi32(source, _mm256_packus_epi16(low, high)));
    }
    blend_sse2(to + i, from + i, count - i);
}

[[gnu::target("avx2")]] void blend_faded_avx2(
    Pixel* to, const Pixel* from, int count, unsigned opacity
) {
    constexpr int lanes = 8;
    const __m256i zero = _mm256_setzero_si256();
    const __m256i full = _mm256_set1_epi16(255);
    const __m256i half = _mm256_set1_epi16(128);
    const __m256i factor = _mm256_set1_epi16(static_cast<short>(opacity));
    int i = 0;
    for (; i + lanes <= count; i += lanes) {
        const __m256i unfaded = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from + i));
        if (_mm256_testz_si256(unfaded, unfaded) != 0) {
            continue;
        }
        __m256i low = _mm256_mullo_epi16(_mm256_unpacklo_epi8(unfaded, zero), factor);
        __m256i high = _mm256_mullo_epi16(_mm256_unpackhi_epi8(unfaded, zero), factor);
        low = _mm256_add_epi16(low, half);
        high = _mm256_add_epi16(high, half);
        low = _mm256_srli_epi16(_mm256_add_epi16(low, _mm256_srli_epi16(low, 8)), 8);
        high = _mm256_srli_epi16(_mm256_add_epi16(high, _mm256_srli_epi16(high, 8)), 8);
        const __m256i source = _mm256_packus_epi16(low, high);

        auto* const place = reinterpret_cast<__m256i*>(to + i);
        const __m256i target = _mm256_loadu_si256(place);
        low = _mm256_shufflehi_epi16(_mm256_shufflelo_epi16(low, 0xFF), 0xFF);
        high = _mm256_shufflehi_epi16(_mm256_shufflelo_epi16(high, 0xFF), 0xFF);
        low = _mm256_mullo_epi16(_mm256_unpacklo_epi8(target, zero), _mm256_sub_epi16(full, low));
        high = _mm256_mullo_epi16(_mm256_unpackhi_epi8(target, zero), _mm256_sub_epi16(full, high));
        low = _mm256_add_epi16(low, half);
        high = _mm256_add_epi16(high, half);
        low = _mm256_srli_epi16(_mm256_add_epi16(low, _mm256_srli_epi16(low, 8)), 8);
        high = _mm256_srli_epi16(_mm256_add_epi16(high, _mm256_srli_epi16(high, 8)), 8);
        _mm256_storeu_si256(place, _mm256_add_epi32(source, _mm256_packus_epi16(low, high)));
    }
    blend_faded_sse2(to + i, from + i, count - i, opacity);
}

}  // namespace hyrax
