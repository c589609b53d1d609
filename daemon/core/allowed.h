// SPDX-License-Identifier: MIT
// Where the user lets pets be: which monitors, and which part of the desktop. Pure.
#pragma once

#include "daemon/core/arena.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hyrax {

/// How config.json names a monitor: its number as a text, from 1 for the primary one, "primary",
/// its name or its identity.
struct MonitorName {
    std::string text;
    bool operator==(const MonitorName&) const = default;
};

struct AllowedSettings {
    std::vector<MonitorName> monitors{};  ///< Empty: all.
    std::optional<Rect> area{};           ///< Of the virtual desktop [px]; none: all of it.
    bool operator==(const AllowedSettings&) const = default;
};

struct AllowedPlaces {
    std::vector<Monitor> monitors;  ///< Cut to the area; not empty unless there is no monitor.
    std::string warning;            ///< Why settings were not followed; empty: they were.
};

/// Whether the settings alone let pets be on monitors[index].
bool allowed_by(
    const AllowedSettings& settings, const std::vector<Monitor>& monitors, std::size_t index
);

/// `chosen` holds the user's own choices by identity(), which come before the settings. Where
/// nothing would be left, everything is allowed and the warning says so.
AllowedPlaces allowed_places(
    const std::vector<Monitor>& monitors,
    const AllowedSettings& settings,
    const std::map<std::string, bool>& chosen
);

}  // namespace hyrax
