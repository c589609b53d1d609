// SPDX-License-Identifier: MIT
// The stability catalogue: scenes that break time steppers, each with what must come out of it,
// measured for every integrator.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <string_view>

namespace hyrax::bench {

enum class Column {
    document,             ///< class physics, the document verbatim.
    semi_implicit_euler,  ///< With rates in place of multipliers, and with a state of rest.
    stormer_verlet,
    rk45,  ///< With both tolerances 1e-6.
    exponential_swept,
    exact  ///< The event-driven trajectory.
};

struct NamedColumn {
    Column column;
    std::string_view name;
};

inline constexpr std::array<NamedColumn, 6> columns{{
    {Column::document, "DOC"},
    {Column::semi_implicit_euler, "SIE"},
    {Column::stormer_verlet, "SVS"},
    {Column::rk45, "RK45"},
    {Column::exponential_swept, "EXPS"},
    {Column::exact, "EXACT"},
}};

struct CatalogueCase {
    int id = 0;  ///< As in docs/physics.md; numbers without a scene there have no case here.
    std::string_view text;
    double tolerance = 0.0;               ///< The largest error that passes.
    double (*measure)(Column) = nullptr;  ///< The error, in the unit that the text says, else [px].
};

/// True for values that are not finite as well.
inline bool fails(const CatalogueCase& one, double value) {
    return !(value <= one.tolerance) || !std::isfinite(value);
}

/// All cases, by ascending id.
std::span<const CatalogueCase> catalogue();

}  // namespace hyrax::bench
