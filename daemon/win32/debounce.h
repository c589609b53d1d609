// SPDX-License-Identifier: MIT
// Turns a storm of hints into one event, once it is quiet. Pure.
#pragma once

#include "physics/ticks.h"

#include <algorithm>

namespace hyrax::win32 {

class Debounce {
public:
    /// Fires `quiet` after the latest hint, but at most `patience` after the first one.
    constexpr Debounce(Ticks quiet, Ticks patience) : quiet_(quiet), patience_(patience) {}

    constexpr void hint(Ticks now) {
        if (due_ == never) {
            first_ = now;
        }
        due_ = std::min(now + quiet_, first_ + patience_);
    }
    /// When take() is worth calling; `never` without a hint.
    constexpr Ticks due() const { return due_; }
    /// True once for each storm, when it is due.
    constexpr bool take(Ticks now) {
        if (now < due_) {
            return false;
        }
        due_ = never;
        return true;
    }

private:
    Ticks quiet_;
    Ticks patience_;
    Ticks first_ = 0;
    Ticks due_ = never;
};

}  // namespace hyrax::win32
