// SPDX-License-Identifier: MIT
// The clock and the alarm of the daemon's one thread.
#pragma once

#include "daemon/core/wall_time.h"
#include "daemon/win32/handle.h"
#include "physics/ticks.h"

#include <chrono>

namespace hyrax::win32 {

/// Monotonic; goes on while the machine sleeps.
Ticks clock_now();

/// The time of day, as the user has set it.
WallTime wall_clock();

/// Processor time that the calling thread has used.
std::chrono::nanoseconds thread_processor_time();

/// Of a span that the system counts in 100 ns.
Ticks span_of(const FILETIME& time);

/// A waitable timer with a resolution of about half a millisecond.
class Alarm {
public:
    Alarm();

    /// Signals `event()` once, after this span (at once when it is not positive).
    void set(Ticks span);
    /// No wake-up until the next set().
    void cancel();
    HANDLE event() const { return timer_.raw(); }

private:
    KernelObject timer_;
    bool armed_ = false;
};

}  // namespace hyrax::win32
