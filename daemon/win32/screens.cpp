// SPDX-License-Identifier: MIT
#include "daemon/win32/screens.h"

#include "daemon/win32/monitor_scale.h"
#include "daemon/win32/rect_from.h"
#include "daemon/win32/text.h"

#include <algorithm>

namespace hyrax::win32 {

namespace {

/// [Hz]; 0 or 1 where the display does not tell.
int refresh_rate_of(const wchar_t* device) {
    DEVMODEW mode{};
    mode.dmSize = sizeof mode;
    const bool known = ::EnumDisplaySettingsW(device, ENUM_CURRENT_SETTINGS, &mode) != 0;
    return known ? static_cast<int>(mode.dmDisplayFrequency) : 0;
}

/// Names the device itself; \\.\DISPLAY1 may be another one after a sleep. Empty if unknown.
std::string interface_path(const wchar_t* display) {
    DISPLAY_DEVICEW device{};
    device.cb = sizeof device;
    const BOOL known = ::EnumDisplayDevicesW(display, 0, &device, EDD_GET_DEVICE_INTERFACE_NAME);
    return known != 0 ? utf8(device.DeviceID) : std::string();
}

BOOL CALLBACK add_monitor(HMONITOR handle, HDC, RECT*, LPARAM list) noexcept {
    MONITORINFOEXW info{};
    info.cbSize = sizeof info;
    if (::GetMonitorInfoW(handle, &info) == 0) {
        return TRUE;
    }
    try {
        reinterpret_cast<std::vector<Monitor>*>(list)->push_back({
            .bounds = rect_from(info.rcMonitor),
            .work = rect_from(info.rcWork),
            .primary = (info.dwFlags & MONITORINFOF_PRIMARY) != 0,
            .name = utf8(info.szDevice),
            .id = interface_path(info.szDevice),
            .scale = monitor_scale(handle),
            .refresh_rate = refresh_rate_of(info.szDevice),
        });
    } catch (const std::exception&) {
        return FALSE;
    }
    return TRUE;
}

}  // namespace

std::vector<Monitor> read_monitors() {
    std::vector<Monitor> monitors;
    ::EnumDisplayMonitors(nullptr, nullptr, add_monitor, reinterpret_cast<LPARAM>(&monitors));
    std::ranges::stable_partition(monitors, &Monitor::primary);
    return monitors;
}

}  // namespace hyrax::win32
