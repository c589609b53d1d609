// SPDX-License-Identifier: MIT
// Times of impact against solutions to 50 digits, and the phi-functions against their series.
#include "physics/time_of_impact.h"

#include "physics/phi.h"
#include "tests/physics/random_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace hyrax;
using namespace hyrax::test;

namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();

struct Reference {
    std::string function;
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
    double d = 0.0;
    double time = 0.0;
    double sensitivity = 0.0;
};

std::vector<Reference> read_impacts() {
    std::ifstream stream(std::string(HYRAX_SOURCE_DIR) + "/tests/golden/impacts.csv");
    std::vector<Reference> references;
    for (std::string line; std::getline(stream, line);) {
        std::istringstream row(line);
        Reference reference;
        std::getline(row, reference.function, ',');
        for (double* const value :
             {&reference.a,
              &reference.b,
              &reference.c,
              &reference.d,
              &reference.time,
              &reference.sensitivity}) {
            std::string text;
            std::getline(row, text, ',');
            *value = std::strtod(text.c_str(), nullptr);
        }
        references.push_back(reference);
    }
    return references;
}

double time_of(const Reference& r) {
    if (r.function == "fall") {
        return fall_time(r.a, r.b, r.c, r.d);
    }
    return r.function == "rise" ? rise_time(r.a, r.b, r.c, r.d) : glide_time(r.a, r.b, r.c);
}

// phi2 by its series, in the form without cancellation: phi_n(z) = e^z sum of positive terms.
double phi2_of(double z) {
    // phi2(z) = e^z (1/2 - z/3 + ...): Kummer's transformation of 1F1(1; 3; z) / 2.
    double term = 0.5;
    double sum = term;
    for (int n = 1; n < 400; ++n) {
        term *= -z * (n + 1.0) / ((n + 2.0) * n);
        sum += term;
    }
    return std::exp(z) * sum;
}

}  // namespace

TEST_CASE("times of impact: as exact as their inputs allow") {
    const std::vector<Reference> references = read_impacts();
    CHECK(references.size() >= 600);
    double worst = 0.0;
    int undecided = 0;
    for (const Reference& r : references) {
        CAPTURE(r.function);
        CAPTURE(r.a);
        CAPTURE(r.b);
        CAPTURE(r.c);
        CAPTURE(r.d);
        const double time = time_of(r);
        if (r.sensitivity == infinity) {
            ++undecided;
            continue;
        }
        if (r.time == infinity || r.time == 0.0) {
            CHECK(time == r.time);
            continue;
        }
        const double error = std::fabs(time - r.time) / r.time;
        // Next to the apex two roots all but coincide, and the iteration creeps: what is missing
        // there is worth less than 1e-9 px, since the body all but stands.
        const double roundings =
            r.sensitivity < 1e4 ? 2.0 + 2.0 * r.sensitivity : 400.0 * r.sensitivity;
        CHECK(error <= rounding * roundings);
        worst = std::max(worst, error / rounding / roundings);
    }
    MESSAGE("worst error: ", worst, " of the bound");
    CHECK(undecided <= 10);
}

TEST_CASE("a hop off the floor is exact to the last bits, however weak the drag") {
    double worst = 0.0;
    for (const Reference& r : read_impacts()) {
        if (r.function == "fall" && r.a == 0.0 && r.b < 0.0 && r.d * -r.b / r.c <= 1.1e4) {
            CAPTURE(r.b);
            CAPTURE(r.d);
            const double error = std::fabs(time_of(r) - r.time) / r.time;
            worst = std::max(worst, error);
            CHECK(error <= 6e-16);
        }
    }
    MESSAGE("worst ", worst);
}

TEST_CASE("phi-functions: relative errors below 1e-15 from -1000 to -1e-18") {
    double worst1 = 0.0;
    double worst2 = 0.0;
    Random random(1);
    for (int i = 0; i < 100'000; ++i) {
        const double z = i % 10 == 0 ? -random.between(0.2, 0.3) : -random.scale(1e-18, 1000.0);
        CAPTURE(z);
        const PhiFunctions phi = phi_functions(z);
        const double phi1 = std::expm1(z) / z;
        worst1 = std::max(worst1, std::fabs(phi.phi1 - phi1) / phi1);
        // Where neither the series nor the quotient cancels.
        const double phi2 = z > -20.0 ? phi2_of(z) : (phi1 - 1.0) / z;
        worst2 = std::max(worst2, std::fabs(phi.phi2 - phi2) / phi2);
        // Of the unit: what is left of a velocity is added to others.
        CHECK(std::fabs(phi.exp - std::exp(z)) <= 2.0 * rounding);
    }
    MESSAGE("worst ", worst1, " and ", worst2);
    CHECK(worst1 <= 1e-15);
    // The reference has an error of its own of this size.
    CHECK(worst2 <= 4e-15);
    CHECK(phi_functions(0.0).phi2 == 0.5);
    CHECK(phi_functions(-0.0).phi1 == 1.0);
    CHECK(phi_functions(-infinity).phi1 == 0.0);
    CHECK(phi_functions(-infinity).exp == 0.0);
}

TEST_CASE("what is never met takes for ever, and what is met already no time") {
    CHECK(fall_time(-1.0, 0.0, 1200.0, 0.06) == infinity);
    CHECK(fall_time(-1.0, 100.0, 1200.0, 0.0) == infinity);
    CHECK(fall_time(0.0, 0.0, 1200.0, 0.06) == 0.0);
    CHECK(fall_time(0.0, 50.0, 1200.0, 0.0) == 0.0);
    CHECK(fall_time(10.0, 0.0, 0.0, 0.06) == infinity);
    CHECK(fall_time(10.0, -5.0, 0.0, 0.06) == infinity);
    CHECK(rise_time(0.0, 5.0, 1200.0, 0.06) == 0.0);
    CHECK(rise_time(100.0, 10.0, 1200.0, 0.06) == infinity);
    CHECK(glide_time(0.0, 5.0, 1e300) == 0.0);
    CHECK(glide_time(5.0, 5.0, 1.0) == infinity);
    CHECK(decay_time(100.0, 5.0, 0.0) == infinity);
    CHECK(decay_time(4.0, 5.0, 1.0) == 0.0);
    CHECK(decay_time(std::exp(1.0), 1.0, 2.0) == doctest::Approx(0.5));
}
