// SPDX-License-Identifier: MIT
// Other programs, as hyrax meets them, and what they can see of its windows.
//   policy_probe front x y width height
//       Shows a window there and takes the foreground.
//   policy_probe panes
//       Prints a line for each pane.
//   policy_probe watch seconds
//       Looks at panes all the time; prints how often one was visible, visible without NonRudeHWND,
//       and below a visible window.
//   policy_probe send class message wparam lparam
//       Sends it, a number or the name of a registered one, to each window of the class.
//   policy_probe post class message count
//       Posts it that many times.
//   policy_probe flood message wparam lparam
//       Posts a thousand messages of no meaning to the daemon, then this one.
//   policy_probe lower
//       Takes its place on top from each pane, and tells of a new front window.
//   policy_probe end_session
//       Ends the session, and the daemon's process with it.
#include "tests/end_to_end/probe_window.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

std::string class_of(HWND window) {
    char name[128] = "";
    ::GetClassNameA(window, name, sizeof name);
    return name;
}

struct Search {
    std::string class_name;
    std::vector<HWND> found;
};

BOOL CALLBACK collect(HWND window, LPARAM search) {
    auto& wanted = *reinterpret_cast<Search*>(search);
    if (class_of(window) == wanted.class_name) {
        wanted.found.push_back(window);
    }
    return TRUE;
}

std::vector<HWND> windows_of(const std::string& class_name) {
    Search search{class_name, {}};
    ::EnumWindows(collect, reinterpret_cast<LPARAM>(&search));
    return search.found;
}

// How many windows that are seen come before it and cover a part of it.
int covers(HWND pane) {
    RECT area{};
    ::GetWindowRect(pane, &area);
    int count = 0;
    for (HWND above = ::GetWindow(pane, GW_HWNDPREV); above != nullptr;
         above = ::GetWindow(above, GW_HWNDPREV)) {
        RECT place{};
        RECT both{};
        if (::IsWindowVisible(above) != 0 && ::GetWindowRect(above, &place) != 0 &&
            ::IntersectRect(&both, &area, &place) != 0) {
            ++count;
        }
    }
    return count;
}

int show_panes() {
    for (const HWND pane : windows_of("hyrax.pane")) {
        RECT r{};
        ::GetWindowRect(pane, &r);
        const LONG_PTR style = ::GetWindowLongPtrW(pane, GWL_EXSTYLE);
        std::printf(
            "pane %ld %ld %ld %ld visible %d rude %d topmost %d toolwindow %d noactivate %d front "
            "%d covers %d\n",
            r.left,
            r.top,
            r.right - r.left,
            r.bottom - r.top,
            ::IsWindowVisible(pane) != 0,
            ::GetPropW(pane, L"NonRudeHWND") == nullptr,
            (style & WS_EX_TOPMOST) != 0,
            (style & WS_EX_TOOLWINDOW) != 0,
            (style & WS_EX_NOACTIVATE) != 0,
            ::GetForegroundWindow() == pane,
            covers(pane)
        );
    }
    DWORD in_front = 0;
    DWORD of_daemon = 0;
    ::GetWindowThreadProcessId(::GetForegroundWindow(), &in_front);
    ::GetWindowThreadProcessId(::FindWindowW(L"hyrax.daemon", nullptr), &of_daemon);
    std::printf("hyrax in front %d\n", in_front == of_daemon);
    std::puts("end");
    return 0;
}

int watch(double seconds) {
    const ULONGLONG end = ::GetTickCount64() + static_cast<ULONGLONG>(seconds * 1000.0);
    int seen = 0;
    int rude = 0;
    int covered = 0;
    hyrax::probe::tell("ready");
    while (::GetTickCount64() < end) {
        for (const HWND pane : windows_of("hyrax.pane")) {
            covered += covers(pane) > 0 ? 1 : 0;
            const bool has_property = ::GetPropW(pane, L"NonRudeHWND") != nullptr;
            if (::IsWindowVisible(pane) != 0) {
                ++seen;
                rude += has_property ? 0 : 1;
            }
        }
        ::Sleep(1);
    }
    std::printf("seen %d rude %d covered %d\n", seen, rude, covered);
    return 0;
}

/// Wine itself tells nobody of a new front window.
void tell_of_front(HWND window) {
    ::NotifyWinEvent(EVENT_SYSTEM_FOREGROUND, window, OBJID_WINDOW, CHILDID_SELF);
}

int stay_in_front(int x, int y, int width, int height) {
    const HWND window = hyrax::probe::show_window({
        .name = L"hyrax policy probe",
        .x = x,
        .y = y,
        .width = width,
        .height = height,
        .brush = BLACK_BRUSH,
    });
    if (window == nullptr) {
        return 1;
    }
    ::SetForegroundWindow(window);
    tell_of_front(window);
    hyrax::probe::tell(::GetForegroundWindow() == window ? "ready" : "not in front");
    return hyrax::probe::run();
}

int send(const std::string& class_name, UINT message, WPARAM wparam, LPARAM lparam) {
    RECT suggested{0, 0, 2000, 2000};
    if (message == WM_DPICHANGED) {
        lparam = reinterpret_cast<LPARAM>(&suggested);
    }
    for (const HWND window : windows_of(class_name)) {
        const LRESULT answer = ::SendMessageW(window, message, wparam, lparam);
        std::printf("answer %lld\n", static_cast<long long>(answer));
    }
    return 0;
}

int post(const std::string& class_name, UINT message, int count) {
    int posted = 0;
    for (const HWND window : windows_of(class_name)) {
        for (int i = 0; i < count; ++i) {
            posted += ::PostMessageW(window, message, 0, 0) != 0 ? 1 : 0;
        }
    }
    std::printf("posted %d\n", posted);
    return 0;
}

HWND daemon() {
    const std::vector<HWND> found = windows_of("hyrax.daemon");
    return found.empty() ? nullptr : found.front();
}

int flood(UINT message, WPARAM wparam, LPARAM lparam) {
    int posted = 0;
    for (int i = 0; i < 1000; ++i) {
        posted += ::PostMessageW(daemon(), WM_APP + 99, 0, 0) != 0 ? 1 : 0;
    }
    posted += ::PostMessageW(daemon(), message, wparam, lparam) != 0 ? 1 : 0;
    std::printf("posted %d\n", posted);
    return 0;
}

int lower() {
    const HWND window =
        hyrax::probe::show_window({.name = L"hyrax policy probe", .width = 50, .height = 50});
    constexpr UINT only_order = SWP_NOMOVE | SWP_NOSIZE | SWP_NOACTIVATE;
    for (const HWND pane : windows_of("hyrax.pane")) {
        ::SetWindowPos(pane, HWND_NOTOPMOST, 0, 0, 0, 0, only_order);
    }
    tell_of_front(window);
    hyrax::probe::tell("ready");
    return hyrax::probe::run();
}

/// Windows may end a process as soon as it has answered.
int end_session() {
    const HWND window = daemon();
    DWORD id = 0;
    ::GetWindowThreadProcessId(window, &id);
    const HANDLE process = ::OpenProcess(PROCESS_TERMINATE, FALSE, id);
    const LRESULT may_end = ::SendMessageW(window, WM_QUERYENDSESSION, 0, 0);
    ::SendMessageW(window, WM_ENDSESSION, TRUE, 0);
    ::TerminateProcess(process, 7);
    std::printf("answer %lld\n", static_cast<long long>(may_end));
    return 0;
}

}  // namespace

int main(int count, char** words) {
    const std::vector<std::string> given(words + 1, words + count);
    const std::string what = given.empty() ? "" : given[0];
    const auto number = [&](std::size_t i) { return std::atoi(given[i].c_str()); };
    if (what == "front" && given.size() == 5) {
        return stay_in_front(number(1), number(2), number(3), number(4));
    }
    if (what == "panes") {
        return show_panes();
    }
    if (what == "watch" && given.size() == 2) {
        return watch(std::atof(given[1].c_str()));
    }
    if (what == "send" && given.size() == 5) {
        const UINT named = ::RegisterWindowMessageA(given[2].c_str());
        return send(
            given[1],
            number(2) != 0 ? static_cast<UINT>(number(2)) : named,
            static_cast<WPARAM>(number(3)),
            static_cast<LPARAM>(number(4))
        );
    }
    if (what == "post" && given.size() == 4) {
        return post(given[1], static_cast<UINT>(number(2)), number(3));
    }
    if (what == "flood" && given.size() == 4) {
        return flood(
            static_cast<UINT>(number(1)),
            static_cast<WPARAM>(number(2)),
            static_cast<LPARAM>(number(3))
        );
    }
    if (what == "lower") {
        return lower();
    }
    if (what == "end_session") {
        return end_session();
    }
    std::fputs("usage: see the head of policy_probe.cpp\n", stderr);
    return 2;
}
