// SPDX-License-Identifier: MIT
#pragma once

#include "physics/ticks.h"

#include <algorithm>

namespace hyrax {

/// So many at once, and so many a second from then on. Starts full.
class Quota {
public:
    struct Rate {
        double at_once = 1.0;  ///< At least 1.
        double per_second = 1.0;
    };

    /// Takes one, if there is one; the rate may be another each time.
    bool take(Ticks now, const Rate& rate) {
        const double earned = to_seconds(std::max<Ticks>(0, now - now_)) * rate.per_second;
        used_ = std::max(0.0, used_ - earned);
        now_ = std::max(now_, now);
        if (used_ + 1.0 > rate.at_once) {
            return false;
        }
        used_ += 1.0;
        return true;
    }

private:
    Ticks now_ = 0;
    double used_ = 0.0;
};

}  // namespace hyrax
