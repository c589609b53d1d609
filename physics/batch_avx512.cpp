// SPDX-License-Identifier: MIT
// The document's step for eight bodies at a time; built like batch_avx2.cpp.
#include "physics/batch.h"

#include <immintrin.h>

namespace hyrax {

[[gnu::target("avx512f")]] void step_avx512(const BatchStep& step) {
    const BatchArrays arrays = step.arrays;
    const __m512d zero = _mm512_setzero_pd();
    const __m512d dt = _mm512_set1_pd(step.dt);
    const __m512d fall = _mm512_set1_pd(step.fall);
    const __m512d drag = _mm512_set1_pd(step.air_drag);
    const __m512d reflection = _mm512_set1_pd(step.reflection);
    const __m512d friction = _mm512_set1_pd(step.ground_friction);
    const __m512d threshold = _mm512_set1_pd(step.rest_threshold);
    const __m512d right = _mm512_set1_pd(step.right);
    const __m512d bottom = _mm512_set1_pd(step.bottom);

    for (std::size_t i = 0; i < arrays.bodies; i += 8) {
        __m512d vx = _mm512_mul_pd(_mm512_loadu_pd(arrays.vx + i), drag);
        const __m512d x = _mm512_add_pd(_mm512_loadu_pd(arrays.x + i), _mm512_mul_pd(vx, dt));
        // Of equal operands and of NaN, min returns the second one: -0 and NaN stay as they are.
        const __mmask8 not_left_of = _mm512_cmp_pd_mask(x, zero, _CMP_NLT_UQ);
        const __m512d clamped_x = _mm512_maskz_min_pd(not_left_of, right, x);
        const __mmask8 hit_x = _mm512_cmp_pd_mask(clamped_x, x, _CMP_NEQ_OQ);
        _mm512_storeu_pd(arrays.x + i, clamped_x);
        vx = _mm512_mask_mul_pd(vx, hit_x, vx, reflection);

        __m512d vy = _mm512_mul_pd(_mm512_add_pd(_mm512_loadu_pd(arrays.vy + i), fall), drag);
        const __m512d y = _mm512_add_pd(_mm512_loadu_pd(arrays.y + i), _mm512_mul_pd(vy, dt));
        const __mmask8 not_above = _mm512_cmp_pd_mask(y, zero, _CMP_NLT_UQ);
        const __m512d clamped_y = _mm512_maskz_min_pd(not_above, bottom, y);
        const __mmask8 hit_y = _mm512_cmp_pd_mask(clamped_y, y, _CMP_NEQ_OQ);
        _mm512_storeu_pd(arrays.y + i, clamped_y);
        vy = _mm512_mask_mul_pd(vy, hit_y, vy, reflection);

        const __mmask8 on_ground = _mm512_mask_cmp_pd_mask(not_above, y, bottom, _CMP_GT_OQ);
        vx = _mm512_mask_mul_pd(vx, on_ground, vx, friction);
        _mm512_storeu_pd(arrays.vx + i, vx);
        const __m512d speed = _mm512_abs_pd(vy);
        const __mmask8 rests = _mm512_mask_cmp_pd_mask(on_ground, speed, threshold, _CMP_LT_OQ);
        vy = _mm512_mask_mov_pd(vy, rests, zero);
        _mm512_storeu_pd(arrays.vy + i, vy);
    }
}

}  // namespace hyrax
