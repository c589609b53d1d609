// SPDX-License-Identifier: MIT
#include "physics/document_body.h"

#include <algorithm>
#include <cmath>

namespace hyrax {

DocumentBody::DocumentBody(
    Vec2 position, Vec2 velocity, const PhysicsConstants& constants, const Rect& home, Size size
)
    : body_(position.x - home.x, position.y - home.y, velocity.x, velocity.y),
      home_(home),
      size_(size) {
    body_.setConstants(constants);
    // A body wider or higher than its room is pinned: the law alone would flicker between two
    // places.
    home_.width = std::max(home.width, size.width);
    home_.height = std::max(home.height, size.height);
    const double right = home_.width - size.width;
    const double bottom = home_.height - size.height;
    body_.setPos(std::clamp(body_.x(), 0.0, right), std::clamp(body_.y(), 0.0, bottom));
}

void DocumentBody::advance(Ticks now, std::vector<TrajectoryEvent>& events) {
    const double dt = to_seconds(std::min(now - stepped_at_, longest_step));
    stepped_at_ = now;
    if (mode_ == Mode::rest || dt <= 0.0) {
        return;
    }
    // What the law makes of the velocity before it meets anything: the speed of an impact.
    const PhysicsConstants& law = body_.constants();
    const double arriving_x = body_.vx() * law.air_drag;
    const double arriving_y = (body_.vy() + law.gravity * dt) * law.air_drag;
    body_.update(dt, home_.width, home_.height, size_.width, size_.height);

    const auto tell = [&events, now](ContactKind kind, double speed) {
        events.push_back({now, kind, std::fabs(speed)});
    };
    if (body_.x() == 0.0 && arriving_x < 0.0) {
        tell(ContactKind::left_wall, arriving_x);
    } else if (body_.x() == home_.width - size_.width && arriving_x > 0.0) {
        tell(ContactKind::right_wall, arriving_x);
    }
    if (body_.y() == 0.0 && arriving_y < 0.0) {
        tell(ContactKind::ceiling, arriving_y);
    }
    if (body_.y() == home_.height - size_.height && body_.vy() <= 0.0) {
        if (++frames_on_floor_ == 1 && arriving_y > 0.0) {
            tell(ContactKind::floor, arriving_y);
        }
    } else {
        frames_on_floor_ = 0;
    }
    update_mode();
}

void DocumentBody::update_mode() {
    const PhysicsConstants& law = body_.constants();
    const double speed = std::hypot(body_.vx(), body_.vy());
    const bool floats_still =
        law.gravity == 0.0 && (speed == 0.0 || (law.air_drag < 1.0 && speed < stop_speed));
    const bool settled = frames_on_floor_ >= frames_until_settled;
    if (floats_still || (settled && std::fabs(body_.vx()) < stop_speed)) {
        body_.resetVelocity();
        mode_ = Mode::rest;
    } else {
        mode_ = settled ? Mode::ground : Mode::air;
    }
}

}  // namespace hyrax
