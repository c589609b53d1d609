// SPDX-License-Identifier: MIT
// What the desktop tells for presence.h, and how it follows.
#include "daemon/win32/win32_desktop.h"

#include <algorithm>

namespace hyrax::win32 {

void Win32Desktop::follow(const Conduct& conduct) {
    const Ticks time = clock_now();
    conduct_ = conduct;
    front_->set(conduct.front, conduct.name_programs, time);
    overlay_.hide_from_capture(conduct.hide_from_capture);
    bubbles_.hide_from_capture(conduct.hide_from_capture);
    overlay_.use_layer(conduct.layer);
    bubbles_.use_layer(conduct.layer);
    overlay_.use_clicks(conduct.click_through ? PaneClicks::pass_through : PaneClicks::on_pixels);
    if (conduct.let_go) {
        pointer_.give_up();
    }
    tell_facts(time);
}

Ticks Win32Desktop::presence_due() const {
    return std::min({front_->due(), machine_->due(), topmost_.due()});
}

void Win32Desktop::look_around(Ticks time) {
    if (time >= machine_->due()) {
        machine_->retry(time);
    }
    if (time >= front_->due()) {
        front_->look(screens_.current(), time, facts_);
    }
    keep_on_top(time);
    tell_facts(time);
}

void Win32Desktop::keep_on_top(Ticks time) {
    const bool exposed = conduct_.layer == Layer::above_taskbar &&
                         conduct_.front == Watch::closely && overlay_.visible() &&
                         reaches_taskbars(overlay_.frame(), screens_.current());
    topmost_.set_exposed(exposed, time);
    if (time < topmost_.due()) {
        return;
    }
    const bool buried = overlay_.buried() || bubbles_.buried();
    const TopmostKeeper::Sight sight{
        .buried = buried,
        .flyout_in_front = buried && front_->flyout_in_front(),
    };
    if (topmost_.check(sight, time)) {
        overlay_.raise();
        bubbles_.raise();
    }
}

void Win32Desktop::notice(UINT message, WPARAM wparam, LPARAM lparam) {
    const Ticks time = clock_now();
    switch (message) {
        case front_message:
        case appbar_message:
            front_->hint(time);
            if (overlay_.visible() && conduct_.layer != Layer::bottom) {
                topmost_.hint(time);
            }
            return;
        case test_fact_message:
            if (options_.for_testing) {
                take_test_fact(static_cast<TestFact>(wparam), lparam);
            }
            break;
        case WM_POWERBROADCAST:
        case WM_WTSSESSION_CHANGE:
        case WM_SETTINGCHANGE:
            MachineWatch::take(message, wparam, lparam, facts_);
            break;
        default:
            return;
    }
    tell_facts(time);
}

void Win32Desktop::take_test_fact(TestFact fact, LPARAM value) {
    switch (fact) {
        case TestFact::on_battery:
            facts_.on_battery = value != 0;
            break;
        case TestFact::battery_saver:
            facts_.battery_saver = value != 0;
            break;
        case TestFact::remote_session:
            facts_.remote_session = value != 0;
            break;
        case TestFact::display_off:
            facts_.display_off = value != 0;
            break;
        case TestFact::animations:
            facts_.animations = value != 0;
            break;
        case TestFact::monitors:
            most_screens_ = static_cast<std::size_t>(value);
            on_screens_hint();
            break;
        case TestFact::wider:
            wider_ = static_cast<int>(value);
            on_screens_hint();
            break;
    }
}

/// The time is that of the message: the inputs may be read after the machine has slept.
void Win32Desktop::tell_facts(Ticks time) {
    facts_.capture_refused = overlay_.capture_refused();
    const bool little = (conduct_.resting || facts_.battery_saver) && !conduct_.dragging;
    if (little != little_power_) {
        little_power_ = little;
        ask_for_little_power(little);
    }
    if (facts_ == told_facts_) {
        return;
    }
    if (told_facts_.suspended && !facts_.suspended) {
        screens_.woke_up(time);
        overlay_.forget_pixels();
        bubbles_.forget_pixels();
    } else if (told_facts_.locked && !facts_.locked) {
        screens_.hint(time);
    }
    told_facts_ = facts_;
    inbox_.emplace_back(input::FactsChanged{facts_, time});
}

std::vector<Monitor> Win32Desktop::read_screens() const {
    std::vector<Monitor> screens = options_.monitors();
    screens.resize(std::min(screens.size(), most_screens_));
    if (!screens.empty()) {
        screens.front().bounds.width += wider_;
        screens.front().work.width += wider_;
    }
    return screens;
}

}  // namespace hyrax::win32
