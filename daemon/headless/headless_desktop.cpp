// SPDX-License-Identifier: MIT
#include "daemon/headless/headless_desktop.h"

#include "daemon/core/blit.h"
#include "daemon/headless/memory_overlay.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace hyrax {

HeadlessDesktop::HeadlessDesktop(std::vector<Monitor> monitors, Ticks end)
    : monitors_(std::move(monitors)), end_(end) {}

void HeadlessDesktop::add(TimedInput input) {
    const auto place = std::upper_bound(
        inputs_.begin() + static_cast<std::ptrdiff_t>(next_),
        inputs_.end(),
        input,
        [](const TimedInput& a, const TimedInput& b) { return a.time < b.time; }
    );
    inputs_.insert(place, std::move(input));
}

std::optional<Point> HeadlessDesktop::pointer() {
    ++pointer_readings_;
    return pointer_;
}

Result<void> HeadlessDesktop::take_hotkey(HotkeyId id, const KeyCombination& keys) {
    if (std::ranges::find(occupied_, keys) != occupied_.end()) {
        return failure("another program has it");
    }
    const bool is_new = hotkeys_.emplace(id, keys).second;
    return is_new ? Result<void>() : failure("its number is taken");
}

std::vector<DesktopWindow> HeadlessDesktop::windows() {
    ++window_readings_;
    const auto next = std::ranges::upper_bound(windows_, now_, {}, &TimedWindows::time);
    return next == windows_.begin() ? std::vector<DesktopWindow>{} : std::prev(next)->windows;
}

void HeadlessDesktop::watch_windows(const WindowInterest& interest) {
    if (interest.any && !interest_.any) {
        told_ = now_;
    }
    interest_ = interest;
}

void HeadlessDesktop::read_aside(std::unique_ptr<SpriteReading> reading) {
    reading_ = std::move(reading);
    reading_->run();
    read_at_ = now_ + reading_time_;
}

std::unique_ptr<SpriteReading> HeadlessDesktop::sprites_read() {
    return now_ >= read_at_ ? std::move(reading_) : nullptr;
}

// When the next change will be told.
Ticks HeadlessDesktop::window_change() const {
    const auto next = std::ranges::upper_bound(windows_, told_, {}, &TimedWindows::time);
    return interest_.any && next != windows_.end() ? next->time : never;
}

std::vector<Input> HeadlessDesktop::wait(Ticks deadline) {
    if (before_time_moves_ && before_time_moves_()) {
        return {input::ScriptsHeard{}};
    }
    const Ticks input_time = next_ < inputs_.size() ? inputs_[next_].time : never;
    const Ticks window_time = window_change();
    const Ticks read_time = reading_ ? std::max(read_at_, now_) : never;
    const Ticks wake = std::min({deadline, input_time, window_time, read_time, end_});
    now_ = std::max(now_, wake == never ? now_ : wake);
    if (wake == never || (now_ >= end_ && input_time > end_)) {
        return {Request{request::Quit{}}};
    }
    std::vector<Input> due;
    if (read_time <= now_) {
        due.emplace_back(input::SpritesRead{});
    }
    if (window_time <= now_) {
        told_ = now_;
        due.emplace_back(input::WindowsChanged{});
    }
    for (; next_ < inputs_.size() && inputs_[next_].time <= now_; ++next_) {
        if (inputs_[next_].before) {
            inputs_[next_].before();
        }
        due.push_back(inputs_[next_].input);
        follow_pointer(due.back());
    }
    ++counters_.wakeups;
    counters_.timer_wakeups += due.empty() ? 1U : 0U;
    return due;
}

void HeadlessDesktop::follow_pointer(const Input& input) {
    if (const auto* const moved = std::get_if<input::Moved>(&input)) {
        pointer_ = moved->at;
    } else if (const auto* const pressed = std::get_if<input::Pressed>(&input)) {
        pointer_ = pressed->at;
    }
}

void HeadlessDesktop::present(const Frame& frame) {
    frame_ = frame;
    ++counters_.overlay.frames;
    if (counters_.first_frame == never && !frame.sprites.empty()) {
        counters_.first_frame = now_;
    }
}

Image picture(const Frame& frame, const std::vector<Monitor>& monitors) {
    Rect bounds;
    for (const Monitor& monitor : monitors) {
        bounds = united(bounds, monitor.bounds);
    }
    Image image(Size{bounds.width, bounds.height});
    compose(PixelView(image), {bounds.x, bounds.y}, bounds, flattened(frame));
    return image;
}

}  // namespace hyrax
