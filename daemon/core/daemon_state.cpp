// SPDX-License-Identifier: MIT
// What the user decides about the whole: hidden, quiet, where pets may be, which scripts run. It
// outlives the program in state.json.
#include "daemon/core/daemon.h"
#include "daemon/core/log_failure.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

namespace hyrax {
namespace {

constexpr const char* greeting =
    "hyrax lives in the tray: right-click its head for the menu. Drag a hyrax to throw it.";

}  // namespace

// --- memory ----------------------------------------------------------------------------------

void Daemon::recall() {
    if (profile_.state.empty()) {
        return;
    }
    Result<Remembered> loaded = load_remembered(profile_.state);
    if (!loaded) {
        const std::string& text = loaded.error().message;
        spdlog::warn("{}; the menu's choices are forgotten", text.substr(0, text.find('\n')));
        return;
    }
    remembered_ = *std::move(loaded);
    saved_ = remembered_;
    heed_presence(desktop_.now());
    show_when_due(desktop_.now());
}

void Daemon::remember() {
    if (profile_.state.empty() || saved_ == remembered_) {
        return;
    }
    saved_ = remembered_;
    log_failure(save_remembered(profile_.state, remembered_));
}

void Daemon::greet() {
    if (!profile_.state.empty() && !std::exchange(remembered_.greeted, true)) {
        desktop_.greet(greeting);
        remember();
    }
}

// --- hidden and paused -----------------------------------------------------------------------

void Daemon::carry_out(const request::SetPaused& pause) {
    paused_ = pause.paused;
    heed_presence(desktop_.now());
}

void Daemon::carry_out(const request::TogglePause&) {
    carry_out(request::SetPaused{!paused_});
}

void Daemon::carry_out(const request::Hide& hide) {
    let_go(desktop_.now(), 0.0);
    remembered_.hidden = true;
    remembered_.hidden_until.reset();
    if (hide.seconds) {
        remembered_.hidden_until = desktop_.wall_time().seconds + *hide.seconds;
    }
    remember();
    heed_presence(desktop_.now());
    show_at_ = never;
    show_when_due(desktop_.now());
}

void Daemon::carry_out(const request::Show&) {
    remembered_.hidden = false;
    remembered_.hidden_until.reset();
    show_at_ = never;
    remember();
    heed_presence(desktop_.now());
}

// The time of day decides, not the timer that was set: the machine may have slept, and the user
// may have set the clock.
void Daemon::show_when_due(Ticks now) {
    if (!remembered_.hidden || !remembered_.hidden_until) {
        show_at_ = never;
        return;
    }
    const std::int64_t left = *remembered_.hidden_until - desktop_.wall_time().seconds;
    if (left <= 0) {
        carry_out(request::Show{});
    } else if (show_at_ == never || now >= show_at_) {
        constexpr std::int64_t longest = std::int64_t{100} * 365 * 24 * 3600;
        show_at_ = now + std::min(left, longest) * ticks_per_second;
    }
}

// --- quiet and untouched ---------------------------------------------------------------------

void Daemon::carry_out(const request::SetQuiet& wish) {
    remembered_.quiet.reset();
    if (wish.quiet != config_.quiet) {
        remembered_.quiet = wish.quiet;
    }
    remember();
    keep_quiet();
}

void Daemon::carry_out(const request::SetClickThrough& wish) {
    remembered_.click_through.reset();
    if (wish.on != config_.click_through) {
        remembered_.click_through = wish.on;
    }
    remember();
    if (wish.on) {
        let_go(desktop_.now(), 0.0);
    }
}

void Daemon::keep_quiet() {
    const bool begins = quiet() && !scripts_.quiet();
    scripts_.set_quiet(quiet());
    if (begins) {
        settle();
    }
}

void Daemon::settle() {
    std::vector<PetId> all;
    engine_.for_each([&all](PetId id, const Pet&) { all.push_back(id); });
    for (const PetId id : all) {
        log_failure(engine_.stop(id));
    }
}

// --- places ----------------------------------------------------------------------------------

bool Daemon::is_allowed(std::size_t monitor) const {
    const auto choice = remembered_.monitors.find(identity(all_monitors_[monitor]));
    return choice != remembered_.monitors.end()
               ? choice->second
               : allowed_by(config_.allowed, all_monitors_, monitor);
}

void Daemon::carry_out(const request::SetMonitor& wish) {
    const auto found = std::ranges::find(all_monitors_, wish.monitor, identity);
    if (found == all_monitors_.end()) {
        spdlog::warn("there is no monitor \"{}\" (any more)", wish.monitor);
        return;
    }
    remembered_.monitors.erase(wish.monitor);
    const auto index = static_cast<std::size_t>(found - all_monitors_.begin());
    if (allowed_by(config_.allowed, all_monitors_, index) != wish.allowed) {
        remembered_.monitors[wish.monitor] = wish.allowed;
    }
    remember();
    let_go(desktop_.now(), 0.0);
    use_monitors();
}

void Daemon::carry_out(const request::Gather&) {
    if (monitors_.empty() || engine_.arena().empty()) {
        return;
    }
    if (remembered_.hidden) {
        carry_out(request::Show{});
    }
    const std::optional<Point> pointer = desktop_.pointer();
    auto target = std::ranges::find_if(monitors_, [&pointer](const Monitor& monitor) {
        return pointer && monitor.bounds.contains(*pointer);
    });
    if (target == monitors_.end()) {
        target = std::ranges::find(monitors_, true, &Monitor::primary);
    }
    const Rect& bounds = target != monitors_.end() ? target->bounds : monitors_.front().bounds;
    engine_.gather(
        engine_.arena().box_near({bounds.x + bounds.width / 2.0, bounds.y + bounds.height / 2.0})
    );
}

// --- scripts ---------------------------------------------------------------------------------

void Daemon::carry_out(const request::SetScript& wish) {
    if (std::ranges::find(script_names_, wish.script) == script_names_.end()) {
        spdlog::warn("there is no script \"{}\" (any more)", wish.script);
        return;
    }
    if (wish.on) {
        remembered_.scripts_off.erase(wish.script);
    } else {
        remembered_.scripts_off.insert(wish.script);
    }
    remember();
    read_scripts();
}

}  // namespace hyrax
