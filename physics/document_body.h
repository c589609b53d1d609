// SPDX-License-Identifier: MIT
// The document's class as a body: one update for each frame, and a rule that lets it sleep.
#pragma once

#include "physics/geometry.h"
#include "physics/physics.h"
#include "physics/ticks.h"
#include "physics/trajectory.h"

#include <vector>

namespace hyrax {

class DocumentBody {
public:
    /// A frame never moves a body by more than this: after a hitch it goes on, it does not leap.
    static constexpr Ticks longest_step = 100 * ticks_per_ms;
    /// The document's law never comes to rest at 60 Hz: the vertical velocity cycles between 0 and
    /// -12 px/s while the position stays on the floor (docs/physics.md). So many frames in a row on
    /// the floor tell that cycle from a bounce, which leaves the floor in the next frame.
    static constexpr int frames_until_settled = 3;
    /// Slower than this a settled body stands still [px/s]: below a tenth of a pixel a frame.
    static constexpr double stop_speed = 5.0;

    DocumentBody() = default;
    /// A body of this size in a room; position relative to the desktop, not to the room.
    DocumentBody(
        Vec2 position, Vec2 velocity, const PhysicsConstants& constants, const Rect& home, Size size
    );

    void start(Ticks now) { stepped_at_ = now; }
    /// One frame; contacts are appended to `events`.
    void advance(Ticks now, std::vector<TrajectoryEvent>& events);

    Vec2 position() const { return {home_.x + body_.x(), home_.y + body_.y()}; }
    Vec2 velocity() const { return {body_.vx(), body_.vy()}; }
    Mode mode() const { return mode_; }

private:
    void update_mode();

    physics body_;
    Rect home_;
    Size size_;
    Ticks stepped_at_ = 0;
    int frames_on_floor_ = 0;
    Mode mode_ = Mode::air;
};

}  // namespace hyrax
