// SPDX-License-Identifier: MIT
// The document's step for two bodies at a time: what every x86-64 has.
#include "physics/batch.h"

#include <emmintrin.h>

namespace hyrax {

void step_sse2(const BatchStep& step) {
    const BatchArrays arrays = step.arrays;
    const __m128d zero = _mm_setzero_pd();
    const __m128d one = _mm_set1_pd(1.0);
    const __m128d sign = _mm_set1_pd(-0.0);
    const __m128d dt = _mm_set1_pd(step.dt);
    const __m128d fall = _mm_set1_pd(step.fall);
    const __m128d drag = _mm_set1_pd(step.air_drag);
    const __m128d one_to_reflection = _mm_xor_pd(one, _mm_set1_pd(step.reflection));
    const __m128d one_to_friction = _mm_xor_pd(one, _mm_set1_pd(step.ground_friction));
    const __m128d threshold = _mm_set1_pd(step.rest_threshold);
    const __m128d right = _mm_set1_pd(step.right);
    const __m128d bottom = _mm_set1_pd(step.bottom);

    for (std::size_t i = 0; i < arrays.bodies; i += 2) {
        __m128d vx = _mm_mul_pd(_mm_loadu_pd(arrays.vx + i), drag);
        const __m128d x = _mm_add_pd(_mm_loadu_pd(arrays.x + i), _mm_mul_pd(vx, dt));
        // Of equal operands and of NaN, min returns the second one: -0 and NaN stay as they are.
        const __m128d left_of = _mm_cmplt_pd(x, zero);
        const __m128d hit_x = _mm_or_pd(left_of, _mm_cmpgt_pd(x, right));
        _mm_storeu_pd(arrays.x + i, _mm_andnot_pd(left_of, _mm_min_pd(right, x)));
        // A factor of 1 where nothing is hit: without a blend instruction this is the shortest.
        vx = _mm_mul_pd(vx, _mm_xor_pd(one, _mm_and_pd(hit_x, one_to_reflection)));

        __m128d vy = _mm_mul_pd(_mm_add_pd(_mm_loadu_pd(arrays.vy + i), fall), drag);
        const __m128d y = _mm_add_pd(_mm_loadu_pd(arrays.y + i), _mm_mul_pd(vy, dt));
        const __m128d above = _mm_cmplt_pd(y, zero);
        const __m128d on_ground = _mm_andnot_pd(above, _mm_cmpgt_pd(y, bottom));
        const __m128d hit_y = _mm_or_pd(above, on_ground);
        _mm_storeu_pd(arrays.y + i, _mm_andnot_pd(above, _mm_min_pd(bottom, y)));
        vy = _mm_mul_pd(vy, _mm_xor_pd(one, _mm_and_pd(hit_y, one_to_reflection)));

        vx = _mm_mul_pd(vx, _mm_xor_pd(one, _mm_and_pd(on_ground, one_to_friction)));
        _mm_storeu_pd(arrays.vx + i, vx);
        const __m128d slow = _mm_cmplt_pd(_mm_andnot_pd(sign, vy), threshold);
        vy = _mm_andnot_pd(_mm_and_pd(on_ground, slow), vy);
        _mm_storeu_pd(arrays.vy + i, vy);
    }
}

}  // namespace hyrax
