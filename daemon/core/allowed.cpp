// SPDX-License-Identifier: MIT
#include "daemon/core/allowed.h"

#include <fmt/format.h>

#include <algorithm>

namespace hyrax {
namespace {

std::vector<Monitor> cut_to(std::vector<Monitor> monitors, const Rect& area) {
    for (Monitor& monitor : monitors) {
        monitor.bounds = intersection(monitor.bounds, area);
        monitor.work = intersection(monitor.work, area);
    }
    std::erase_if(monitors, [](const Monitor& monitor) { return monitor.bounds.empty(); });
    return monitors;
}

}  // namespace

bool allowed_by(
    const AllowedSettings& settings, const std::vector<Monitor>& monitors, std::size_t index
) {
    const Monitor& monitor = monitors[index];
    const std::string number = fmt::format("{}", index + 1);
    return settings.monitors.empty() ||
           std::ranges::any_of(settings.monitors, [&](const MonitorName& name) {
               return name.text == number || name.text == monitor.name ||
                      name.text == identity(monitor) || (monitor.primary && name.text == "primary");
           });
}

AllowedPlaces allowed_places(
    const std::vector<Monitor>& monitors,
    const AllowedSettings& settings,
    const std::map<std::string, bool>& chosen
) {
    AllowedPlaces result{.monitors = {}, .warning = {}};
    for (std::size_t i = 0; i < monitors.size(); ++i) {
        const auto choice = chosen.find(identity(monitors[i]));
        if (choice != chosen.end() ? choice->second : allowed_by(settings, monitors, i)) {
            result.monitors.push_back(monitors[i]);
        }
    }
    if (result.monitors.empty() && !monitors.empty()) {
        result.monitors = monitors;
        result.warning = "none of the allowed monitors is there: pets may be on all of them "
                         "(config.json: /overlay/allowed_monitors, or the tray menu's Monitors)";
    }
    if (settings.area) {
        std::vector<Monitor> cut = cut_to(result.monitors, *settings.area);
        if (!cut.empty() || monitors.empty()) {
            result.monitors = std::move(cut);
        } else {
            result.warning = "config.json: /overlay/allowed_area: no allowed monitor shows any of "
                             "it, so pets may be anywhere";
        }
    }
    return result;
}

}  // namespace hyrax
