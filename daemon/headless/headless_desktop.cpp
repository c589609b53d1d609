// SPDX-License-Identifier: MIT
#include "daemon/headless/headless_desktop.h"

#include "daemon/core/blit.h"

#include <algorithm>
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

std::vector<Input> HeadlessDesktop::wait(Ticks deadline) {
    if (before_time_moves_ && before_time_moves_()) {
        return {input::ScriptsHeard{}};
    }
    const Ticks input_time = next_ < inputs_.size() ? inputs_[next_].time : never;
    const Ticks wake = std::min({deadline, input_time, end_});
    now_ = std::max(now_, wake == never ? now_ : wake);
    if (wake == never || (now_ >= end_ && input_time > end_)) {
        return {Request{request::Quit{}}};
    }
    std::vector<Input> due;
    for (; next_ < inputs_.size() && inputs_[next_].time <= now_; ++next_) {
        if (inputs_[next_].before) {
            inputs_[next_].before();
        }
        due.push_back(inputs_[next_].input);
    }
    timer_wakeups_ += due.empty() ? 1U : 0U;
    return due;
}

void HeadlessDesktop::present(const Frame& frame) {
    frame_ = frame;
    ++presents_;
}

Image picture(const Frame& frame, const std::vector<Monitor>& monitors) {
    Rect bounds;
    for (const Monitor& monitor : monitors) {
        bounds = united(bounds, monitor.bounds);
    }
    Image image(Size{bounds.width, bounds.height});
    compose(PixelView(image), {bounds.x, bounds.y}, bounds, frame);
    return image;
}

}  // namespace hyrax
