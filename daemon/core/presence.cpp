// SPDX-License-Identifier: MIT
#include "daemon/core/presence.h"

#include "daemon/core/ascii.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace hyrax {

namespace {

constexpr Ticks enter_after = 300 * ticks_per_ms;
constexpr Ticks leave_after = ticks_per_second;

/// The desktop itself, taskbars, and what the shell opens over a whole screen: the Start menu,
/// search, the overview of windows.
constexpr std::array<std::string_view, 7> shell_classes{
    "Progman",
    "WorkerW",
    "Shell_TrayWnd",
    "Shell_SecondaryTrayWnd",
    "Windows.UI.Core.CoreWindow",
    "XamlExplorerHostIslandWindow",
    "MultitaskingViewFrame",
};

bool same_name(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, {}, lower_ascii, lower_ascii);
}

bool could_be_in_the_way(const FrontWindow& window) {
    return window.visible && !window.cloaked &&
           std::ranges::find(shell_classes, window.window_class) == shell_classes.end();
}

/// [frames/s]; infinite where it does not tell.
double rate_of(const Monitor& monitor) {
    if (monitor.refresh_rate <= 1) {
        return infinity;
    }
    // Cut to a whole number: 59 stands for 59.94.
    const bool cut = (monitor.refresh_rate + 1) % 6 == 0;
    return monitor.refresh_rate + (cut ? 1 : 0);
}

}  // namespace

bool fills(const FrontWindow& window, const Monitor& monitor) {
    if (!could_be_in_the_way(window) || !window.bounds.contains(monitor.bounds)) {
        return false;
    }
    // Where no taskbar keeps room (hidden automatically, or on another screen), an ordinary
    // maximised window covers the screen as well.
    const bool can_be_maximised = monitor.work == monitor.bounds;
    return !(can_be_maximised && (window.captioned || window.maximised));
}

void Presence::set_monitors(std::span<const Monitor> monitors) {
    std::vector<Watched> next;
    for (const Monitor& monitor : monitors) {
        const auto known = std::ranges::find(monitors_, monitor.bounds, [](const Watched& place) {
            return place.monitor.bounds;
        });
        Watched place = known != monitors_.end() ? *known : Watched{};
        place.monitor = monitor;
        next.push_back(std::move(place));
    }
    monitors_ = std::move(next);
}

const Decisions& Presence::decide(Ticks now) {
    const FrontWindow* const window = front();
    const FullScreenRule* const rule = window != nullptr ? rule_for(*window) : nullptr;
    const bool must_go = rule != nullptr && rule->act == FullScreenAct::hide_everywhere;
    settle(everywhere_, must_go ? FullScreenAct::hide_everywhere : FullScreenAct::stay, now);

    Decisions next;
    for (Watched& place : monitors_) {
        settle(place, wanted_on(place.monitor), now);
        if (place.act == FullScreenAct::hide || place.act == FullScreenAct::hide_everywhere) {
            next.kept_free.push_back(place.monitor.bounds);
        }
        if (place.act != FullScreenAct::stay) {
            next.frozen.push_back(place.monitor.bounds);
        }
    }
    next.windowless = everywhere_.act == FullScreenAct::hide_everywhere;
    next.unseen = facts_.locked || facts_.disconnected || facts_.display_off || facts_.suspended;
    next.world_stands = next.windowless || (next.unseen && settings_.on_resume == OnResume::go_on);
    if (facts_.on_battery) {
        next.fps = settings_.fps_on_battery;
    }
    if (facts_.battery_saver || facts_.remote_session) {
        next.fps = std::min(next.fps, settings_.fps_saving);
    }
    next.calm = settings_.reduced_motion == ReducedMotion::on ||
                (settings_.reduced_motion == ReducedMotion::automatic && !facts_.animations);
    next.note = note_on(next);
    decisions_ = std::move(next);
    return decisions_;
}

Ticks Presence::due() const {
    Ticks due = switches_at(everywhere_);
    for (const Watched& place : monitors_) {
        due = std::min(due, switches_at(place));
    }
    return due;
}

bool Presence::wary() const {
    const auto quiet = [](const Watched& place) {
        return place.act == FullScreenAct::stay && place.wanted == FullScreenAct::stay;
    };
    return !quiet(everywhere_) || !std::ranges::all_of(monitors_, quiet);
}

bool Presence::may_disturb() const {
    const bool asked_for_quiet =
        facts_.shell == ShellState::presenting || facts_.shell == ShellState::exclusive;
    const bool filled = std::ranges::any_of(facts_.windows, [this](const FrontWindow& window) {
        return std::ranges::any_of(monitors_, [&window](const Watched& place) {
            return fills(window, place.monitor);
        });
    });
    return !asked_for_quiet && !filled && !wary() && !decisions_.unseen;
}

FullScreenAct Presence::wanted_on(const Monitor& monitor) const {
    if (facts_.shell == ShellState::presenting) {
        return settings_.full_screen;
    }
    if (facts_.shell == ShellState::exclusive) {
        const FrontWindow* const window = front();
        if (window == nullptr && monitor.primary) {
            return settings_.full_screen;
        }
        if (window != nullptr && works_on(monitor)) {
            return act_for(*window);
        }
    }
    for (const FrontWindow& window : facts_.windows) {
        // A film keeps its screen while the user works on another one, not below a window that
        // was called before it.
        const bool on_top = &window == front() || !works_on(monitor);
        if (on_top && fills(window, monitor)) {
            return act_for(window);
        }
    }
    return FullScreenAct::stay;
}

FullScreenAct Presence::act_for(const FrontWindow& window) const {
    const FullScreenRule* const rule = rule_for(window);
    return rule != nullptr ? rule->act : settings_.full_screen;
}

const FullScreenRule* Presence::rule_for(const FrontWindow& window) const {
    const auto found = std::ranges::find_if(settings_.rules, [&](const FullScreenRule& rule) {
        return same_name(rule.program, window.program);
    });
    return found != settings_.rules.end() ? &*found : nullptr;
}

const FrontWindow* Presence::front() const {
    const bool known = facts_.first_is_front && !facts_.windows.empty();
    return known ? &facts_.windows.front() : nullptr;
}

/// The front window lies on this monitor more than on any other. The desktop and what else is the
/// shell's hides no other window.
bool Presence::works_on(const Monitor& monitor) const {
    const FrontWindow* const window = front();
    if (window == nullptr || !could_be_in_the_way(*window)) {
        return false;
    }
    const auto share = [window](const Rect& bounds) {
        return intersection(window->bounds, bounds).area();
    };
    const long long here = share(monitor.bounds);
    return here > 0 && std::ranges::all_of(monitors_, [&](const Watched& other) {
               return share(other.monitor.bounds) <= here;
           });
}

Ticks Presence::switches_at(const Watched& place) {
    if (place.act == place.wanted) {
        return never;
    }
    switch (place.wanted) {
        case FullScreenAct::stay:
            return place.since + leave_after;
        case FullScreenAct::hide_everywhere:
            return place.since;
        case FullScreenAct::hide:
        case FullScreenAct::pause:
            return place.since + enter_after;
    }
    std::unreachable();
}

void Presence::settle(Watched& place, FullScreenAct wanted, Ticks now) {
    if (place.wanted != wanted) {
        place.wanted = wanted;
        place.since = now;
    }
    if (now >= switches_at(place)) {
        place.act = wanted;
    }
}

double Presence::refresh_rate_at(std::span<const Rect> places) const {
    double fastest = 0.0;
    for (const Watched& watched : monitors_) {
        const Rect& bounds = watched.monitor.bounds;
        const bool shows = std::ranges::any_of(places, [&bounds](const Rect& place) {
            return !intersection(place, bounds).empty();
        });
        if (watched.act != FullScreenAct::hide && shows) {
            fastest = std::max(fastest, rate_of(watched.monitor));
        }
    }
    return fastest > 0.0 ? fastest : infinity;
}

double Presence::least_refresh_rate() const {
    double least = infinity;
    for (const Watched& place : monitors_) {
        least = std::min(least, rate_of(place.monitor));
    }
    return least;
}

std::string Presence::note_on(const Decisions& decisions) const {
    if (decisions.windowless) {
        const FrontWindow* const window = front();
        return window != nullptr ? "hidden while " + window->program + " is in front" : "hidden";
    }
    std::string note;
    if (decisions.calm) {
        note = "reduced motion: pets move only when they are thrown";
    }
    if (!decisions.frozen.empty()) {
        note += note.empty() ? "" : "; ";
        note += decisions.kept_free.empty() ? "still" : "hidden";
        note += " where a program fills the screen";
    }
    return note;
}

}  // namespace hyrax
