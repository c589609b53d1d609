// SPDX-License-Identifier: MIT
// The table of config.json's keys: where each value goes, its range, its unit, its meaning.
// Knows nothing of JSON; config_json.cpp reads and describes by it.
#pragma once

#include "daemon/core/config.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace hyrax {

/// In the order of FloorEdge.
inline constexpr std::array<std::string_view, 2> floor_names{"work_area", "screen"};

/// In the order of FullScreenAct; the last one in rules alone.
inline constexpr std::array<std::string_view, 4> full_screen_names{
    "hide", "pause", "stay", "hide_everywhere"
};

/// In the order of OnResume.
inline constexpr std::array<std::string_view, 2> resume_names{"go_on", "catch_up"};

/// In the order of ReducedMotion.
inline constexpr std::array<std::string_view, 3> motion_names{"auto", "on", "off"};
/// In the order of Renderer.
inline constexpr std::array<std::string_view, 2> renderer_names{"blit", "gdiplus"};
/// In the order of Layer.
inline constexpr std::array<std::string_view, 3> layer_names{"above_taskbar", "top", "bottom"};

/// In the order of LedgeMode.
inline constexpr std::array<std::string_view, 3> ledge_names{"off", "active", "all"};

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

/// The place of an enumerator that goes by a name: the field's choices[i] stands for the value i.
class Choice {
public:
    template <typename Enum>
        requires std::is_enum_v<Enum>
    explicit Choice(Enum& place)
        : place_(&place),
          index_([](const void* value) {
              return static_cast<std::size_t>(*static_cast<const Enum*>(value));
          }),
          set_([](void* value, std::size_t index) {
              *static_cast<Enum*>(value) = static_cast<Enum>(index);
          }) {}

    std::size_t index() const { return index_(place_); }
    void set(std::size_t index) const { set_(place_, index); }

private:
    void* place_;
    std::size_t (*index_)(const void*);
    void (*set_)(void*, std::size_t);
};

/// Where a value goes; the type decides how it is read.
using Slot = std::variant<
    Ignored,
    double*,
    std::optional<double>*,
    bool*,
    int*,
    std::size_t*,
    std::int64_t*,
    std::string*,
    Choice,
    std::vector<std::string>*,
    std::vector<MonitorName>*,
    std::optional<Rect>*,
    std::optional<KeyCombination>*,
    std::vector<StartPets>*,
    std::vector<FullScreenRule>*,
    std::map<std::string, PluginChoice>*>;

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

/// All of them; the next three are parts of it.
std::span<const Field<Config>> config_table();
std::span<const Field<Config>> overlay_table();
std::span<const Field<Config>> script_table();
std::span<const Field<Config>> hotkey_table();
std::span<const Field<StartItem>> start_table();
std::span<const Field<FullScreenRule>> full_screen_rule_table();

}  // namespace hyrax
