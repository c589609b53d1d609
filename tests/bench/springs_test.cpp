// SPDX-License-Identifier: MIT
#include "tests/bench/bench_springs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

using namespace hyrax;
using namespace hyrax::bench;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// In the order of spring_schemes. 1e30 stands for any larger error, infinity among them: how far
/// an explosion gets in 120 frames says nothing.
constexpr double explosion = 1e30;

struct ExpectedErrors {
    std::string_view name;
    std::array<double, 7> px;
};

constexpr std::array<ExpectedErrors, 8> expected_errors{{
    {"S1", {12.6, 17.1, 5.05, 9.79e-4, 3.57, 10.6, 0.39}},
    {"S2", {explosion, explosion, 56.0, explosion, 0.254, 0.25, 0.181}},
    {"S3", {94.9, explosion, 50.9, 15.7, 8.59, 7.99, 4.16}},
    {"S4", {explosion, explosion, explosion, explosion, 4.36, 3.66, 1.73}},
    {"S5", {explosion, explosion, explosion, explosion, explosion, 5.5, 29.7}},
    {"S7", {explosion, explosion, explosion, explosion, explosion, 0.0617, 49.7}},
    {"S8", {explosion, explosion, explosion, explosion, explosion, 50.0, 96.8}},
    {"S9", {explosion, explosion, explosion, explosion, explosion, 5.35, 30.6}},
}};

struct ExpectedLimits {
    double damping_ratio;
    std::array<double, 8> w_h;
};

constexpr std::array<ExpectedLimits, 5> expected_limits{{
    {0.0, {0.0, 2.00, 2.00, 2.83, 2.00, infinity, infinity, infinity}},
    {0.5, {1.00, 1.24, 2.00, 2.62, 3.24, infinity, infinity, infinity}},
    {1.0, {2.00, 0.83, 2.00, 2.79, 4.83, infinity, infinity, infinity}},
    {2.0, {0.54, 0.47, 1.00, 0.75, 8.47, infinity, infinity, infinity}},
    {10.0, {0.10, 0.10, 0.20, 0.14, 40.1, infinity, infinity, infinity}},
}};

}  // namespace

TEST_CASE("the exact spring follows within a nanopixel where every other scheme fails") {
    REQUIRE(expected_errors.size() == spring_cases.size());
    for (std::size_t i = 0; i < spring_cases.size(); ++i) {
        const SpringCase& scene = spring_cases[i];
        CAPTURE(scene.name);
        REQUIRE(scene.name == expected_errors[i].name);
        for (std::size_t j = 0; j < expected_errors[i].px.size(); ++j) {
            CAPTURE(spring_schemes[j].name);
            const double error = tracking_error(spring_schemes[j].scheme, scene.constants);
            CHECK(error > 1e-9);
            CHECK(
                std::min(error, explosion) ==
                doctest::Approx(expected_errors[i].px[j]).epsilon(0.02)
            );
        }
        CHECK(tracking_error(SpringScheme::exact, scene.constants) < 1e-9);
    }
}

TEST_CASE("the schemes leave their stability limits where theory puts them") {
    for (const ExpectedLimits& expected : expected_limits) {
        CAPTURE(expected.damping_ratio);
        for (std::size_t i = 0; i < spring_schemes.size(); ++i) {
            CAPTURE(spring_schemes[i].name);
            const double limit = stability_limit(spring_schemes[i].scheme, expected.damping_ratio);
            if (std::isinf(expected.w_h[i])) {
                CHECK(limit == infinity);
            } else {
                CHECK(limit == doctest::Approx(expected.w_h[i]).epsilon(0.01));
            }
        }
    }
    // The closed forms behind two columns.
    for (const double zeta : {0.1, 0.5, 1.0, 2.0, 10.0}) {
        const double root = 2.0 * std::sqrt(zeta * zeta + 1.0);
        CHECK(
            stability_limit(SpringScheme::semi_implicit_euler, zeta) ==
            doctest::Approx(root - 2.0 * zeta).epsilon(1e-5)
        );
        CHECK(
            stability_limit(SpringScheme::semi_implicit_damped, zeta) ==
            doctest::Approx(root + 2.0 * zeta).epsilon(1e-5)
        );
    }
}

TEST_CASE("the table and its file hold every scheme and every case") {
    std::ostringstream table;
    std::ostringstream csv;
    springs(table, csv);
    const std::string rows = csv.str();
    const auto lines = static_cast<std::size_t>(std::count(rows.begin(), rows.end(), '\n'));
    CHECK(lines == 1 + (spring_cases.size() + expected_limits.size()) * spring_schemes.size());
    for (const NamedSpringScheme& scheme : spring_schemes) {
        CHECK(table.str().contains(scheme.name));
        CHECK(rows.contains(scheme.name));
    }
}
