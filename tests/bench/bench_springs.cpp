// SPDX-License-Identifier: MIT
#include "tests/bench/bench_springs.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <ostream>

namespace hyrax::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double step_60_hz = 1.0 / 60.0;
constexpr int frames = 120;
constexpr double radius = 200.0;
constexpr double first_offset = 50.0;
constexpr std::array<double, 5> damping_ratios{0.0, 0.5, 1.0, 2.0, 10.0};

SpringMatrix operator*(const SpringMatrix& m, const SpringMatrix& n) {
    return {
        m.a11 * n.a11 + m.a12 * n.a21,
        m.a11 * n.a12 + m.a12 * n.a22,
        m.a21 * n.a11 + m.a22 * n.a21,
        m.a21 * n.a12 + m.a22 * n.a22
    };
}

SpringMatrix inverse(const SpringMatrix& m) {
    const double scale = 1.0 / (m.a11 * m.a22 - m.a12 * m.a21);
    return {m.a22 * scale, -m.a12 * scale, -m.a21 * scale, m.a11 * scale};
}

/// I + h A, with A the matrix of the differential equation.
SpringMatrix euler(const SpringConstants& constants, double h) {
    const auto [w, zeta] = constants;
    return {1.0, h, -h * w * w, 1.0 - 2.0 * zeta * w * h};
}

SpringMatrix runge_kutta(const SpringConstants& constants, double h) {
    const auto [w, zeta] = constants;
    const SpringMatrix ha{0.0, h, -h * w * w, -2.0 * zeta * w * h};
    SpringMatrix sum;  // Horner: I + ha (I + ha/2 (I + ha/3 (I + ha/4)))
    for (const double divisor : {4.0, 3.0, 2.0, 1.0}) {
        const SpringMatrix product = ha * sum;
        sum = {
            1.0 + product.a11 / divisor,
            product.a12 / divisor,
            product.a21 / divisor,
            1.0 + product.a22 / divisor
        };
    }
    return sum;
}

/// A new velocity v = drift e + keep e', then the position with it: e + h v.
SpringMatrix semi_implicit(double drift, double keep, double h) {
    return {1.0 + h * drift, h * keep, drift, keep};
}

SpringMatrix verlet(const SpringConstants& constants, double h) {
    const auto [w, zeta] = constants;
    const double kick = -0.5 * h * w * w;
    const double keep = 1.0 - zeta * w * h;
    const SpringMatrix first = semi_implicit(kick, keep, h);
    const SpringMatrix last{1.0, 0.0, kick, keep};
    return last * first;
}

struct Reference {
    long double e = 0.0L;
    long double rate = 0.0L;
};

/// From the complex roots of s^2 + 2 zeta w s + w^2, as the product's propagator is not.
Reference solution(const SpringConstants& constants, Reference start, long double t) {
    using Complex = std::complex<long double>;
    const long double w = constants.frequency;
    const long double zeta = constants.damping_ratio;
    if (zeta == 1.0L) {
        const long double slope = start.rate + w * start.e;
        const long double e = std::exp(-w * t) * (start.e + slope * t);
        return {e, std::exp(-w * t) * slope - w * e};
    }
    const Complex root = w * std::sqrt(Complex(zeta * zeta - 1.0L));
    const Complex p = -zeta * w + root;
    const Complex q = -zeta * w - root;
    const Complex a = (start.rate - q * start.e) / (p - q);
    const Complex at = a * std::exp(p * t);
    const Complex bt = (start.e - a) * std::exp(q * t);
    return {(at + bt).real(), (p * at + q * bt).real()};
}

/// The cursor at a frame.
Vec2 cursor(int frame) {
    const double angle = 2.0 * std::numbers::pi * frame * step_60_hz;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

Vec2 slope_after(int frame) {
    return (cursor(frame + 1) - cursor(frame)) * (1.0 / step_60_hz);
}

/// The largest absolute eigenvalue.
double spectral_radius(const SpringMatrix& m) {
    const std::complex<double> half_trace = 0.5 * (m.a11 + m.a22);
    const double determinant = m.a11 * m.a22 - m.a12 * m.a21;
    const auto root = std::sqrt(half_trace * half_trace - determinant);
    return std::max(std::abs(half_trace + root), std::abs(half_trace - root));
}

bool grows(SpringScheme scheme, double damping_ratio, double w_h) {
    // Equal eigenvalues carry half the digits: a hair above 1 is still 1.
    return spectral_radius(step_matrix(scheme, {w_h, damping_ratio}, 1.0)) > 1.0 + 1e-7;
}

void table_head(std::ostream& table, std::string_view corner) {
    table << "| " << corner;
    for (const NamedSpringScheme& scheme : spring_schemes) {
        table << " | " << scheme.name;
    }
    table << " |\n|---";
    for (std::size_t column = 0; column < spring_schemes.size(); ++column) {
        table << "|---";
    }
    table << "|\n";
}

}  // namespace

SpringMatrix step_matrix(SpringScheme scheme, const SpringConstants& constants, double h) {
    const auto [w, zeta] = constants;
    switch (scheme) {
        case SpringScheme::explicit_euler:
            return euler(constants, h);
        case SpringScheme::semi_implicit_euler:
            return semi_implicit(-h * w * w, 1.0 - 2.0 * zeta * w * h, h);
        case SpringScheme::velocity_verlet:
            return verlet(constants, h);
        case SpringScheme::runge_kutta_4:
            return runge_kutta(constants, h);
        case SpringScheme::semi_implicit_damped: {
            const double keep = 1.0 / (1.0 + 2.0 * zeta * w * h);
            return semi_implicit(-h * w * w * keep, keep, h);
        }
        case SpringScheme::backward_euler:
            return inverse(euler(constants, -h));
        case SpringScheme::trapezoid:
            return inverse(euler(constants, -0.5 * h)) * euler(constants, 0.5 * h);
        case SpringScheme::exact:
            return propagator(constants, h);
    }
    return {};
}

double tracking_error(SpringScheme scheme, const SpringConstants& constants) {
    const SpringMatrix matrix = step_matrix(scheme, constants, step_60_hz);
    // The body moves with the cursor when it is taken: e' = 0.
    Vec2 offset{first_offset, 0.0};
    Vec2 rate;
    Reference x{first_offset, 0.0L};
    Reference y;
    double worst = 0.0;
    for (int frame = 0; frame < frames; ++frame) {
        const Vec2 before = offset;
        offset = before * matrix.a11 + rate * matrix.a12;
        rate = before * matrix.a21 + rate * matrix.a22;
        x = solution(constants, x, step_60_hz);
        y = solution(constants, y, step_60_hz);
        const double error =
            std::hypot(offset.x - static_cast<double>(x.e), offset.y - static_cast<double>(y.e));
        worst = std::isfinite(error) ? std::max(worst, error) : infinity;

        const Vec2 bend = slope_after(frame + 1) - slope_after(frame);
        rate = rate - bend;
        x.rate -= static_cast<long double>(bend.x);
        y.rate -= static_cast<long double>(bend.y);
    }
    return worst;
}

double stability_limit(SpringScheme scheme, double damping_ratio) {
    constexpr double smallest = 1e-2;
    constexpr double largest = 1e6;
    if (grows(scheme, damping_ratio, smallest)) {
        return 0.0;
    }
    double stable = smallest;
    double growing = smallest;
    while (growing < largest && !grows(scheme, damping_ratio, growing)) {
        stable = growing;
        growing *= 1.01;
    }
    if (growing >= largest) {
        return infinity;
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (stable + growing);
        (grows(scheme, damping_ratio, middle) ? growing : stable) = middle;
    }
    return stable;
}

void springs(std::ostream& table, std::ostream& csv) {
    csv << "quantity,case,w,damping_ratio,scheme,value\n";
    const std::streamsize csv_precision = csv.precision(6);
    const std::streamsize table_precision = table.precision(3);

    table << "Largest error at 60 Hz [px]\n\n";
    table_head(table, "case");
    for (const SpringCase& scene : spring_cases) {
        const auto [w, zeta] = scene.constants;
        table << "| " << scene.name << ": w=" << w << ", zeta=" << zeta;
        for (const auto& [scheme, name] : spring_schemes) {
            const double error = tracking_error(scheme, scene.constants);
            table << " | " << error;
            csv << "error_px," << scene.name << ',' << w << ',' << zeta << ',' << name << ','
                << error << '\n';
        }
        table << " |\n";
    }

    table << "\nLargest stable w h\n\n";
    table_head(table, "zeta");
    for (const double zeta : damping_ratios) {
        table << "| " << zeta;
        for (const auto& [scheme, name] : spring_schemes) {
            const double limit = stability_limit(scheme, zeta);
            table << " | " << limit;
            csv << "stable_w_h,,," << zeta << ',' << name << ',' << limit << '\n';
        }
        table << " |\n";
    }
    csv.precision(csv_precision);
    table.precision(table_precision);
}

}  // namespace hyrax::bench
