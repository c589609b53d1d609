// SPDX-License-Identifier: MIT
// The phi-functions of exponential integrators (Hochbruck and Ostermann, Acta Numerica 2010).
#pragma once

#include <cmath>

namespace hyrax {

struct PhiFunctions {
    double exp = 1.0;   ///< e^z
    double phi1 = 1.0;  ///< (e^z - 1) / z
    double phi2 = 0.5;  ///< (e^z - 1 - z) / z^2
};

/// For z <= 0, zero and -infinity included; relative errors below 1e-15.
inline PhiFunctions phi_functions(double z) {
    if (z > -0.25) {
        // Taylor up to 1/14!: the quotients would cancel here.
        double phi2 = 1.0 / 87178291200.0;
        phi2 = phi2 * z + 1.0 / 6227020800.0;
        phi2 = phi2 * z + 1.0 / 479001600.0;
        phi2 = phi2 * z + 1.0 / 39916800.0;
        phi2 = phi2 * z + 1.0 / 3628800.0;
        phi2 = phi2 * z + 1.0 / 362880.0;
        phi2 = phi2 * z + 1.0 / 40320.0;
        phi2 = phi2 * z + 1.0 / 5040.0;
        phi2 = phi2 * z + 1.0 / 720.0;
        phi2 = phi2 * z + 1.0 / 120.0;
        phi2 = phi2 * z + 1.0 / 24.0;
        phi2 = phi2 * z + 1.0 / 6.0;
        phi2 = phi2 * z + 1.0 / 2.0;
        const double phi1 = 1.0 + z * phi2;
        return {1.0 + z * phi1, phi1, phi2};
    }
    const double exp_minus_1 = std::expm1(z);
    const double phi1 = exp_minus_1 / z;
    return {1.0 + exp_minus_1, phi1, (phi1 - 1.0) / z};
}

}  // namespace hyrax
