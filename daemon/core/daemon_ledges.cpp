// SPDX-License-Identifier: MIT
// When the daemon looks at other programs' windows, and when it does not.
#include "daemon/core/daemon.h"

#include <utility>

namespace hyrax {

// Nobody has told of changes while nothing was of interest, so a new interest begins with a look.
void Daemon::mind_windows() {
    if (config_.ledges == LedgeMode::off && !windows_.any) {
        return;
    }
    WindowInterest interest;
    if (config_.ledges != LedgeMode::off && !clock_.paused()) {
        interest.underfoot = engine_.windows_underfoot();
        interest.any = engine_.may_meet_ledges() || !interest.underfoot.empty();
    }
    if (interest == windows_) {
        return;
    }
    windows_ = std::move(interest);
    desktop_.watch_windows(windows_);
    if (windows_.any) {
        read_windows();
    }
}

void Daemon::read_windows() {
    if (config_.ledges != LedgeMode::off) {
        engine_.set_ledges(ledges_of(desktop_.windows(), monitors_, config_.ledges));
    } else {
        engine_.set_ledges({});
    }
}

void Daemon::on(const input::WindowsChanged&) {
    read_windows();
}

}  // namespace hyrax
