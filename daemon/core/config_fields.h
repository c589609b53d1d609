// SPDX-License-Identifier: MIT
// The table of config.json's keys: where each value goes, its range, its unit, its meaning.
// Knows nothing of JSON; config_json.cpp reads and describes by it.
#pragma once

#include "daemon/core/config.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hyrax {

/// In the order of FloorEdge.
inline constexpr std::array<std::string_view, 2> floor_names{"work_area", "screen"};

/// In the order of Integrator.
inline constexpr std::array<std::string_view, 6> integrator_names{
    "event_driven",
    "semi_implicit_euler",
    "semi_implicit_euler_fixed",
    "exponential_swept",
    "stormer_verlet",
    "rk45"
};

/// An item of /pets/start while its x and y are still apart.
struct StartItem {
    StartPets pets;
    std::optional<double> x;
    std::optional<double> y;
};

/// The place of a key that only editors read.
struct Ignored {};

/// Where a value goes; the type decides how it is read.
using Slot = std::variant<
    Ignored,
    double*,
    std::optional<double>*,
    int*,
    std::size_t*,
    std::int64_t*,
    std::string*,
    FloorEdge*,
    Integrator*,
    std::vector<std::string>*,
    std::vector<StartPets>*>;

struct FieldRange {
    double low = 0.0;
    double high = 0.0;
};

/// A key of an object that is read into a Target. Defaults are those of a fresh Target.
template <typename Target>
struct Field {
    std::string_view path;  ///< JSON pointer from the Target's object.
    Slot (*slot)(Target&);
    FieldRange range;  ///< Of a number, or of the count of a list's items.
    std::string_view unit;
    std::string_view description;
    std::span<const std::string_view> choices = {};
};

std::span<const Field<Config>> config_table();
std::span<const Field<StartItem>> start_table();

}  // namespace hyrax
