// SPDX-License-Identifier: MIT
#include "daemon/core/pacer.h"

#include <algorithm>

namespace hyrax {

void Pacer::set_rate(double frames_per_second) {
    period_ = std::max<Ticks>(1, from_seconds(1.0 / frames_per_second));
}

void Pacer::drawn(Ticks now) {
    const Ticks late = now - due_;
    // Up to a period late keeps the grid; anything else starts a new one.
    due_ = late >= 0 && late < period_ ? due_ + period_ : now + period_;
}

}  // namespace hyrax
