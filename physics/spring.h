// SPDX-License-Identifier: MIT
// The damped spring that holds a grabbed body on the cursor, solved exactly.
#pragma once

#include "physics/geometry.h"
#include "physics/ticks.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace hyrax {

/// A spring and a damper side by side between the cursor and the body:
/// mass x'' = -stiffness (x - c) - damping (x' - c').
struct SpringConstants {
    /// Undamped angular frequency, sqrt(stiffness / mass) [rad/s]. At 120 an abrupt stop from
    /// 1000 px/s swings 3 px over and is back within one pixel after two frames; higher values pass
    /// on more of the mouse's jitter.
    double frequency = 120.0;
    /// damping / (2 sqrt(stiffness mass)); 1 is the least that comes back without swinging over.
    double damping_ratio = 1.0;

    bool operator==(const SpringConstants&) const = default;
};

/// Takes (e, e') of e'' + 2 zeta w e' + w^2 e = 0 to a later moment. Columns: e [px], e' [px/s].
struct SpringMatrix {
    double a11 = 1.0;
    double a12 = 0.0;
    double a21 = 0.0;
    double a22 = 1.0;

    bool operator==(const SpringMatrix&) const = default;
};

/// The exact solution after `seconds`: the identity for 0, less than 0 and NaN. Always finite. All
/// zero, which is at the target and stays there, where a constant is negative or not finite, or e
/// has decayed below the smallest double.
SpringMatrix propagator(const SpringConstants& constants, double seconds);

/// Where a held body is [px] and how it moves [px/s].
struct SpringBody {
    Vec2 position;
    Vec2 velocity;

    bool operator==(const SpringBody&) const = default;
};

/// Holds one body. The target c(t) glides from each cursor sample to the next on a straight line;
/// on each line e = x - c obeys the equation above, and where lines meet e stays and e' jumps by
/// minus the change of slope. Reads compute from the last sample and change nothing.
class Spring {
public:
    /// Larger positions [px] and velocities [px/s] are refused.
    static constexpr double max_input = 1e12;
    /// A spring above it [rad/s] answers within one tick: it holds the body rigidly on the target.
    static constexpr double max_frequency = 1e9;
    /// A glide to a sample lasts as long as the longer of the last two intervals between samples,
    /// each taken within these bounds.
    static constexpr Ticks min_glide = ticks_per_ms;
    static constexpr Ticks max_glide = ticks_per_second / 60;
    /// A longer silence is a pause of the hand, and no interval between samples.
    static constexpr Ticks longest_interval = 50 * ticks_per_ms;
    /// A throw is averaged over no less.
    static constexpr Ticks shortest_window = 4 * ticks_per_ms;

    /// Negative and non-finite constants hold the body rigidly on the target.
    explicit Spring(const SpringConstants& constants = {});

    const SpringConstants& constants() const { return constants_; }
    /// Takes a body while the target rests. False, and no change, when a number is not finite or
    /// beyond max_input.
    bool grab(const SpringBody& body, Vec2 target, Ticks time);
    /// A cursor sample: where the target is now known to be. False, and no change, when it is not
    /// finite, beyond max_input or earlier than the sample before.
    bool follow(Vec2 target, Ticks time);

    /// Before the last sample the body reads as at the last sample.
    SpringBody at(Ticks time) const;
    /// The gliding target [px].
    Vec2 target(Ticks time) const;
    /// What the hand gives the body: its mean velocity over the longer of the last two intervals
    /// between samples, but nothing against the target's last movement once that has ended, which
    /// is the spring swinging back. Made not longer than `max_speed` [px/s]; zero when that is NaN
    /// or < 0.
    Vec2 release_velocity(Ticks time, double max_speed) const;

private:
    /// From `start` on: the target's line, and the body relative to it.
    struct Leg {
        Ticks start = 0;
        Vec2 target;
        Vec2 slope;
        Vec2 offset;  ///< e
        Vec2 rate;    ///< e'
    };

    /// What one sample made of the target's way.
    struct Segment {
        Leg glide;
        Leg hold;
    };

    const Leg& leg_at(Ticks time) const { return time < hold_.start ? glide_ : hold_; }
    static Leg moved(const Leg& leg, const SpringMatrix& matrix, Ticks to);
    const SpringMatrix& sample_matrix(Ticks from, Ticks to);
    std::size_t remembered() const { return std::min(passed_, past_.size()); }
    /// 1: of the sample before the last one; at most remembered().
    const Segment& past(std::size_t age) const { return past_[(passed_ - age) % past_.size()]; }
    Ticks longer_interval() const { return std::max(intervals_[0], intervals_[1]); }
    SpringBody on(const Leg& leg, Ticks time) const;
    Vec2 place(Ticks time) const;
    Vec2 mean_velocity(Ticks time) const;

    SpringConstants constants_;
    Leg glide_;       ///< From the last sample to the moment when the target reaches it.
    Leg hold_;        ///< From then on, the target at rest.
    Ticks span_ = 0;  ///< Of matrix_ [ns]. Samples of one mouse come at one interval.
    SpringMatrix matrix_;
    std::array<Ticks, 2> intervals_{};  ///< Between the last samples, pauses left out.
    std::array<Segment, 8> past_{};     ///< A ring of those before the current one.
    std::size_t passed_ = 0;
};

}  // namespace hyrax
