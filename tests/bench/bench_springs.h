// SPDX-License-Identifier: MIT
// How the usual time steppers follow a cursor on a spring, against the exact propagator.
#pragma once

#include "physics/spring.h"

#include <array>
#include <iosfwd>
#include <string_view>

namespace hyrax::bench {

enum class SpringScheme {
    explicit_euler,
    semi_implicit_euler,
    velocity_verlet,  ///< Explicit in the damping, as in game engines.
    runge_kutta_4,
    semi_implicit_damped,  ///< Semi-implicit Euler with the damping taken implicitly.
    backward_euler,
    trapezoid,
    exact
};

struct NamedSpringScheme {
    SpringScheme scheme;
    std::string_view name;
};

inline constexpr std::array<NamedSpringScheme, 8> spring_schemes{{
    {SpringScheme::explicit_euler, "explicit Euler"},
    {SpringScheme::semi_implicit_euler, "semi-implicit Euler"},
    {SpringScheme::velocity_verlet, "velocity Verlet"},
    {SpringScheme::runge_kutta_4, "Runge-Kutta 4"},
    {SpringScheme::semi_implicit_damped, "semi-implicit with implicit damping"},
    {SpringScheme::backward_euler, "backward Euler"},
    {SpringScheme::trapezoid, "trapezoid"},
    {SpringScheme::exact, "exact"},
}};

struct SpringCase {
    std::string_view name;
    SpringConstants constants;
};

/// The named cases of the catalogue. S6 has no entry there.
inline constexpr std::array<SpringCase, 8> spring_cases{{
    {"S1", {.frequency = 10.0, .damping_ratio = 0.5}},
    {"S2", {.frequency = 10.0, .damping_ratio = 10.0}},
    {"S3", {.frequency = 100.0, .damping_ratio = 1.0}},
    {"S4", {.frequency = 100.0, .damping_ratio = 2.0}},
    {"S5", {.frequency = 1e3, .damping_ratio = 1.0}},
    {"S7", {.frequency = 1e4, .damping_ratio = 0.1}},
    {"S8", {.frequency = 1e4, .damping_ratio = 0.0}},
    {"S9", {.frequency = 1e4, .damping_ratio = 10.0}},
}};

/// One step of `step` seconds as a matrix on (e, e'): every scheme is linear.
SpringMatrix step_matrix(SpringScheme scheme, const SpringConstants& constants, double step);

/// The largest distance from the exact solution in 120 frames at 60 Hz [px], with the cursor on a
/// circle of 200 px at 1 Hz and the body at first 50 px off. Infinite where the scheme left the
/// numbers.
double tracking_error(SpringScheme scheme, const SpringConstants& constants);

/// The largest w h below which no step of `scheme` grows; 0 if there is none, infinite if all.
double stability_limit(SpringScheme scheme, double damping_ratio);

/// Errors and stability limits, for readers and for machines.
void springs(std::ostream& table, std::ostream& csv);

}  // namespace hyrax::bench
