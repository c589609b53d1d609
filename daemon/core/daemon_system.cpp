// SPDX-License-Identifier: MIT
// What scripts see and ask of the system: the pointer, windows, hotkeys, notices. The user's
// hotkeys.
#include "daemon/core/daemon.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>

namespace hyrax {
namespace {

// Scripts may run in every frame; to read all windows then would cost more than the pets do.
constexpr Ticks windows_stay_fresh = 100 * ticks_per_ms;

// Without what clicks pass through, the desktop itself and taskbars.
std::vector<Rect> visible_frames(const std::vector<DesktopWindow>& windows) {
    std::vector<Rect> frames;
    for (const DesktopWindow& window : windows) {
        if (window.visible && window.solid && window.has_caption && !window.bounds.empty() &&
            frames.size() < ScriptBridge::most_windows) {
            frames.push_back(window.bounds);
        }
    }
    return frames;
}

}  // namespace

ScriptEyes Daemon::script_eyes() {
    return {
        .cursor = [this]() -> std::optional<Vec2> {
            const std::optional<Point> at = desktop_.pointer();
            return at ? std::optional(Vec2{double(at->x), double(at->y)}) : std::nullopt;
        },
        .windows =
            [this] {
                const Ticks now = desktop_.now();
                if (now >= read_windows_again_) {
                    read_windows_again_ = now + windows_stay_fresh;
                    const std::vector<DesktopWindow> windows = desktop_.windows();
                    if (windows_.any) {
                        engine_.set_ledges(ledges_of(windows, monitors_, config_.ledges));
                    }
                    window_frames_ = visible_frames(windows);
                }
                return window_frames_;
            },
    };
}

bool Daemon::is_loaded(std::string_view script) const {
    return std::ranges::find(sources_, script, &ScriptSource::name) != sources_.end();
}

/// Scripts keep their own count of notices; the process that they run in is not believed.
void Daemon::grant(const command::Notify& notice, Ticks now) {
    if (!is_loaded(notice.script)) {
        return;
    }
    Ticks& next = next_notices_[notice.script];
    if (now < next) {
        return;
    }
    // Half: two answers may come closer together than they were given.
    next = now + std::chrono::nanoseconds(config_.limits.notice_pause).count() / 2;
    const bool shown = !quiet() && !remembered_.hidden && presence_.may_disturb();
    spdlog::info("notice of {}: {}{}", notice.script, notice.text, shown ? "" : " (not shown)");
    if (shown) {
        desktop_.notify(notice.script, notice.text);
    }
}

void Daemon::grant(const command::Hotkey& wish, Ticks) {
    if (is_loaded(wish.script)) {
        hotkeys_.obey(desktop_, wish);
    }
}

/// A script could not answer while the world stands still, and nobody wants all of it later.
void Daemon::on(const input::HotkeyPressed& pressed) {
    const std::optional<HotkeyTask> task = hotkeys_.task(pressed.id);
    if (!task) {
        return;
    }
    if (const auto* const hotkey = std::get_if<UserHotkey>(&*task)) {
        carry_out(*hotkey);
    } else if (!clock_.paused()) {
        scripts_.tell(std::get<PressedHotkey>(*task));
    }
}

void Daemon::carry_out(UserHotkey hotkey) {
    switch (hotkey) {
        case UserHotkey::gather:
            return carry_out(request::Gather{});
        case UserHotkey::hide:
            return remembered_.hidden ? carry_out(request::Show{}) : carry_out(request::Hide{});
        case UserHotkey::pause:
            return carry_out(request::TogglePause{});
        case UserHotkey::quiet:
            return carry_out(request::SetQuiet{!quiet()});
        case UserHotkey::click_through:
            return carry_out(request::SetClickThrough{!click_through()});
    }
}

}  // namespace hyrax
