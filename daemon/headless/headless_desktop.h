// SPDX-License-Identifier: MIT
// A desktop made of lists: inputs with times come in, frames are remembered, time is virtual.
#pragma once

#include "daemon/core/desktop.h"

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace hyrax {

/// Something that happens at a moment of the virtual clock.
struct TimedInput {
    Ticks time = 0;
    Input input;
    /// What the world does just before, such as a file that changes.
    std::function<void()> before = {};
};

/// Runs as fast as the machine can. Asked to wait for ever with nothing left to come, it quits.
class HeadlessDesktop : public Desktop {
public:
    HeadlessDesktop(std::vector<Monitor> monitors, Ticks end);

    /// Inputs may be added in any order; those of one moment keep theirs.
    void add(TimedInput input);
    /// Called before time moves on: true if something else happened first, which the daemon then
    /// hears of as an input::ScriptsHeard. So virtual time waits for scripts in another process.
    void before_time_moves(std::function<bool()> wait) { before_time_moves_ = std::move(wait); }
    /// Does not tell the daemon: add an input::MonitorsChanged for that.
    void set_monitors(std::vector<Monitor> monitors) { monitors_ = std::move(monitors); }

    Ticks now() override { return now_; }
    std::vector<Input> wait(Ticks deadline) override;
    void present(const Frame& frame) override;
    std::vector<Monitor> monitors() override { return monitors_; }
    void show_status(const Status& status) override { statuses_.push_back(status); }

    const Frame& last_frame() const { return frame_; }
    std::size_t presents() const { return presents_; }
    /// How often wait() came back because its deadline had come.
    std::size_t timer_wakeups() const { return timer_wakeups_; }
    const std::vector<Status>& statuses() const { return statuses_; }

private:
    std::vector<Monitor> monitors_;
    std::function<bool()> before_time_moves_;
    std::vector<TimedInput> inputs_;  ///< Sorted by time; those before next_ are done.
    std::size_t next_ = 0;
    Ticks now_ = 0;
    Ticks end_;
    Frame frame_;
    std::size_t presents_ = 0;
    std::size_t timer_wakeups_ = 0;
    std::vector<Status> statuses_;
};

/// The frame over the bounding box of the monitors, transparent where no pet is.
Image picture(const Frame& frame, const std::vector<Monitor>& monitors);

}  // namespace hyrax
