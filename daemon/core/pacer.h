// SPDX-License-Identifier: MIT
// When to draw: a grid of absolute deadlines, so that late wake-ups do not add up.
#pragma once

#include "physics/ticks.h"

namespace hyrax {

class Pacer {
public:
    /// [1/s], > 0
    void set_rate(double frames_per_second);
    /// Tells that a frame was drawn for this moment.
    void drawn(Ticks now);
    /// The earliest moment for the next frame: one period after the last one, on its grid. After
    /// a hitch, frames are dropped, not caught up.
    Ticks next() const { return due_; }

private:
    Ticks period_ = ticks_per_second / 60;
    Ticks due_ = 0;
};

}  // namespace hyrax
