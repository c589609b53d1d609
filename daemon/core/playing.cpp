// SPDX-License-Identifier: MIT
#include "daemon/core/playing.h"

#include <algorithm>

namespace hyrax {

std::optional<Shown> shown_of(const Playing& playing, const Animation& animation, Ticks elapsed) {
    const bool loop = playing.loop.value_or(animation.loop);
    const auto frames = static_cast<Ticks>(animation.frames.size());
    const Ticks each = playing.fps ? from_seconds(1.0 / *playing.fps) : 0;
    const Ticks total = playing.fps ? each * frames : animation.duration();
    if (!loop && elapsed >= total) {
        return std::nullopt;
    }
    const Ticks round = elapsed - elapsed % total;
    const Ticks within = elapsed - round;
    if (playing.fps) {
        const Ticks index = within / each;
        const int cell = animation.frames[static_cast<std::size_t>(index)].cell;
        return Shown{cell, round + (index + 1) * each};
    }
    const Shown shown = shown_at(animation, within);
    // One that is made to loop may show one cell for ever; one that ends has something to do then.
    if (shown.until == never && loop && animation.loop) {
        return Shown{shown.cell, never};
    }
    return Shown{shown.cell, round + std::min(shown.until, total)};
}

}  // namespace hyrax
