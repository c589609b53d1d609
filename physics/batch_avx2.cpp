// SPDX-License-Identifier: MIT
// The document's step for four bodies at a time. The attribute, not a compiler flag, asks for AVX2:
// nothing else in this file, such as an inline function of a header, can come out as AVX2 code that
// the linker would then take for all others. No vector is passed by value and every access may be
// unaligned: GCC aligns the stack to 16 bytes only on Windows.
#include "physics/batch.h"

#include <immintrin.h>

namespace hyrax {

[[gnu::target("avx2")]] void step_avx2(const BatchStep& step) {
    const BatchArrays arrays = step.arrays;
    const __m256d zero = _mm256_setzero_pd();
    const __m256d sign = _mm256_set1_pd(-0.0);
    const __m256d dt = _mm256_set1_pd(step.dt);
    const __m256d fall = _mm256_set1_pd(step.fall);
    const __m256d drag = _mm256_set1_pd(step.air_drag);
    const __m256d reflection = _mm256_set1_pd(step.reflection);
    const __m256d friction = _mm256_set1_pd(step.ground_friction);
    const __m256d threshold = _mm256_set1_pd(step.rest_threshold);
    const __m256d right = _mm256_set1_pd(step.right);
    const __m256d bottom = _mm256_set1_pd(step.bottom);

    for (std::size_t i = 0; i < arrays.bodies; i += 4) {
        __m256d vx = _mm256_mul_pd(_mm256_loadu_pd(arrays.vx + i), drag);
        const __m256d x = _mm256_add_pd(_mm256_loadu_pd(arrays.x + i), _mm256_mul_pd(vx, dt));
        // Of equal operands and of NaN, min returns the second one: -0 and NaN stay as they are.
        const __m256d left_of = _mm256_cmp_pd(x, zero, _CMP_LT_OQ);
        const __m256d clamped_x = _mm256_andnot_pd(left_of, _mm256_min_pd(right, x));
        const __m256d hit_x = _mm256_cmp_pd(clamped_x, x, _CMP_NEQ_OQ);
        _mm256_storeu_pd(arrays.x + i, clamped_x);
        vx = _mm256_blendv_pd(vx, _mm256_mul_pd(vx, reflection), hit_x);

        __m256d vy = _mm256_mul_pd(_mm256_add_pd(_mm256_loadu_pd(arrays.vy + i), fall), drag);
        const __m256d y = _mm256_add_pd(_mm256_loadu_pd(arrays.y + i), _mm256_mul_pd(vy, dt));
        const __m256d above = _mm256_cmp_pd(y, zero, _CMP_LT_OQ);
        const __m256d clamped_y = _mm256_andnot_pd(above, _mm256_min_pd(bottom, y));
        const __m256d hit_y = _mm256_cmp_pd(clamped_y, y, _CMP_NEQ_OQ);
        _mm256_storeu_pd(arrays.y + i, clamped_y);
        vy = _mm256_blendv_pd(vy, _mm256_mul_pd(vy, reflection), hit_y);

        const __m256d on_ground = _mm256_andnot_pd(above, hit_y);
        vx = _mm256_blendv_pd(vx, _mm256_mul_pd(vx, friction), on_ground);
        _mm256_storeu_pd(arrays.vx + i, vx);
        const __m256d slow = _mm256_cmp_pd(_mm256_andnot_pd(sign, vy), threshold, _CMP_LT_OQ);
        vy = _mm256_andnot_pd(_mm256_and_pd(on_ground, slow), vy);
        _mm256_storeu_pd(arrays.vy + i, vy);
    }
}

}  // namespace hyrax
