// SPDX-License-Identifier: MIT
#include "daemon/win32/machine_watch.h"

#include "daemon/win32/text.h"

#include <spdlog/spdlog.h>

#include <cstring>

namespace hyrax::win32 {

namespace {

// Of this session's display, unlike GUID_CONSOLE_DISPLAY_STATE. Here because the headers only
// declare it. {2B84C20E-AD23-4DDF-93DB-05FFBD7EFCA5}
constexpr GUID session_display_status{
    0x2b84c20e, 0xad23, 0x4ddf, {0x93, 0xdb, 0x05, 0xff, 0xbd, 0x7e, 0xfc, 0xa5}
};
// Missing in the headers of mingw-w64 10. GUID_POWER_SAVING_STATUS
constexpr GUID power_saving_status{
    0xe00958c0, 0xc213, 0x4ace, {0xac, 0x77, 0xfe, 0xcc, 0xed, 0x2e, 0xee, 0xa5}
};

constexpr Ticks retry_after = 5 * ticks_per_second;
constexpr Ticks patience = 30 * ticks_per_second;

bool same_setting(const GUID& a, const GUID& b) {
    return std::memcmp(&a, &b, sizeof(GUID)) == 0;
}

void read_power(Facts& facts) {
    SYSTEM_POWER_STATUS status{};
    if (::GetSystemPowerStatus(&status) != 0) {
        facts.on_battery = status.ACLineStatus == 0;
        // SystemStatusFlag, which older headers call Reserved1.
        facts.battery_saver = status.Reserved1 == 1;
    }
}

void read_animations(Facts& facts) {
    BOOL animations = TRUE;
    if (::SystemParametersInfoW(SPI_GETCLIENTAREAANIMATION, 0, &animations, 0) != 0) {
        facts.animations = animations != FALSE;
    }
}

void read_remote(Facts& facts) {
    facts.remote_session = ::GetSystemMetrics(SM_REMOTESESSION) != 0;
}

void take_setting(const POWERBROADCAST_SETTING& setting, Facts& facts) {
    DWORD value = 0;
    if (setting.DataLength < sizeof value) {
        return;
    }
    std::memcpy(&value, setting.Data, sizeof value);
    if (same_setting(setting.PowerSetting, session_display_status)) {
        facts.display_off = value == 0;  // 1: on, 2: dimmed.
    } else if (same_setting(setting.PowerSetting, power_saving_status)) {
        facts.battery_saver = value != 0;
    }
}

void take_power(WPARAM event, LPARAM data, Facts& facts) {
    switch (event) {
        case PBT_APMSUSPEND:
            facts.suspended = true;
            break;
        case PBT_APMRESUMEAUTOMATIC:
        case PBT_APMRESUMESUSPEND:
            facts.suspended = false;
            read_power(facts);
            break;
        case PBT_APMPOWERSTATUSCHANGE:
            read_power(facts);
            break;
        case PBT_POWERSETTINGCHANGE:
            if (data != 0) {
                take_setting(*reinterpret_cast<const POWERBROADCAST_SETTING*>(data), facts);
            }
            break;
        default:
            break;
    }
}

void take_session(WPARAM event, Facts& facts) {
    switch (event) {
        case WTS_SESSION_LOCK:
            facts.locked = true;
            break;
        case WTS_SESSION_UNLOCK:
            facts.locked = false;
            break;
        case WTS_CONSOLE_DISCONNECT:
        case WTS_REMOTE_DISCONNECT:
            facts.disconnected = true;
            break;
        case WTS_CONSOLE_CONNECT:
        case WTS_REMOTE_CONNECT:
            facts.disconnected = false;
            read_remote(facts);
            break;
        default:
            break;
    }
}

PowerNotification hear_of(HWND window, const GUID& setting, const char* name) {
    PowerNotification heard(
        ::RegisterPowerSettingNotification(window, &setting, DEVICE_NOTIFY_WINDOW_HANDLE)
    );
    if (!heard) {
        spdlog::info(
            "{}", system_error(std::string("the system tells nothing of ") + name).message
        );
    }
    return heard;
}

}  // namespace

MachineWatch::MachineWatch(HWND window, Ticks now, Facts& facts)
    : window_(window),
      display_(hear_of(window, session_display_status, "the display")),
      saver_(hear_of(window, power_saving_status, "the battery saver")),
      give_up_at_(now + patience) {
    read_power(facts);
    read_animations(facts);
    read_remote(facts);
    retry(now);
}

MachineWatch::~MachineWatch() {
    using Unregister = decltype(::WTSUnRegisterSessionNotification);
    const auto unregister = sessions_.function<Unregister>("WTSUnRegisterSessionNotification");
    if (hears_of_session_ && unregister != nullptr) {
        unregister(window_);
    }
}

void MachineWatch::retry(Ticks now) {
    retry_at_ = never;
    hears_of_session_ = hears_of_session_ || hear_of_session();
    if (hears_of_session_) {
        return;
    }
    if (now < give_up_at_) {
        retry_at_ = now + retry_after;
    } else {
        spdlog::info("{}", system_error("the system tells nothing of locked sessions").message);
    }
}

bool MachineWatch::hear_of_session() {
    using Register = decltype(::WTSRegisterSessionNotification);
    const auto function = sessions_.function<Register>("WTSRegisterSessionNotification");
    return function != nullptr && function(window_, NOTIFY_FOR_THIS_SESSION) != 0;
}

void MachineWatch::take(UINT message, WPARAM wparam, LPARAM lparam, Facts& facts) {
    switch (message) {
        case WM_POWERBROADCAST:
            take_power(wparam, lparam, facts);
            break;
        case WM_WTSSESSION_CHANGE:
            take_session(wparam, facts);
            break;
        case WM_SETTINGCHANGE:
            read_animations(facts);
            break;
        default:
            break;
    }
}

void ask_for_little_power(bool little) {
    PROCESS_POWER_THROTTLING_STATE state{};
    state.Version = PROCESS_POWER_THROTTLING_CURRENT_VERSION;
    state.ControlMask = little ? PROCESS_POWER_THROTTLING_EXECUTION_SPEED : 0U;
    state.StateMask = state.ControlMask;
    ::SetProcessInformation(::GetCurrentProcess(), ProcessPowerThrottling, &state, sizeof state);
}

}  // namespace hyrax::win32
