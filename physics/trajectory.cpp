// SPDX-License-Identifier: MIT
#include "physics/trajectory.h"

#include "physics/fold.h"

#include <cmath>

namespace hyrax {
namespace {

// With more bounces than this in a second, folding them at each read is cheaper than passing them.
constexpr double bounces_worth_folding = 60.0;

// Beyond this span nothing is scheduled [s]: it fits into ticks with room for any uptime.
constexpr double longest_span = 4e9;

}  // namespace

void Trajectory::launch(
    Ticks now,
    Vec2 position,
    Vec2 velocity,
    const Law& law,
    const FreeSpace& space,
    WallEvents walls
) {
    start_ = let_go(position, velocity, law, space);
    since_ = now;
    fraction_ = 0.0;
    walls_ = walls;
    schedule(law, space);
}

BodyState Trajectory::folded(double t, const Law& law, const FreeSpace& space) const {
    BodyState state = free_motion(start_, law, t);
    const FoldedMotion x = fold(
        start_.position.x,
        start_.velocity.x,
        space.corridor(start_.position),
        law.restitution,
        law.drag,
        t
    );
    state.position.x = x.position;
    state.velocity.x = x.velocity;
    return state;
}

TrajectoryEvent Trajectory::pass_event(const Law& law, const FreeSpace& space) {
    BodyState arriving =
        folded_ ? folded(next_.time, law, space) : free_motion(start_, law, next_.time);
    arriving.position = space.above_ledges(start_.position.y, arriving.position);
    const double total = fraction_ + next_.time;
    const double whole = std::floor(total * static_cast<double>(ticks_per_second));
    const auto ticks = static_cast<Ticks>(whole);
    since_ += ticks;
    fraction_ = total - to_seconds(ticks);

    const bool is_wall =
        next_.kind == ContactKind::left_wall || next_.kind == ContactKind::right_wall;
    const double speed = std::fabs(is_wall ? arriving.velocity.x : arriving.velocity.y);
    const TrajectoryEvent event{since_, next_.kind, speed};
    start_ = after_contact(next_, arriving, law, space);
    // Where two contacts nearly coincide, rounding may have put the body beyond the other side.
    start_.position = space.nearest(start_.position);
    schedule(law, space);
    return event;
}

void Trajectory::schedule(const Law& law, const FreeSpace& space) {
    folded_ = false;
    if (walls_ == WallEvents::not_wanted && start_.mode == Mode::air && space.is_box()) {
        const Support walls = space.corridor(start_.position);
        folded_ = std::fabs(start_.velocity.x) > bounces_worth_folding * (walls.right - walls.left);
    }
    next_ = next_contact(start_, law, space, folded_ ? Walls::ignore : Walls::meet);
    bounds_ = {};
    switch (next_.kind) {
        case ContactKind::left_wall:
            bounds_.low.x = next_.side;
            break;
        case ContactKind::right_wall:
            bounds_.high.x = next_.side;
            break;
        case ContactKind::ceiling:
            bounds_.low.y = next_.side;
            break;
        case ContactKind::floor:
            // A step that the body rises past first lies above it still.
            bounds_.high.y = start_.position.y <= next_.side ? next_.side : infinity;
            break;
        case ContactKind::none:
        case ContactKind::edge:
        case ContactKind::stop:
            break;
    }
    const double span = fraction_ + next_.time;
    due_ =
        span < longest_span
            ? since_ + static_cast<Ticks>(std::ceil(span * static_cast<double>(ticks_per_second)))
            : never;
}

void Trajectory::give_up(Ticks now, const Law& law, const FreeSpace& space) {
    const double t = elapsed(now);
    const double drag = start_.mode == Mode::ground ? law.ground_drag : law.drag;
    const FoldedMotion x = fold(
        start_.position.x,
        start_.velocity.x,
        space.corridor(start_.position),
        law.restitution,
        drag,
        t
    );
    // At rest where it already lies on a floor.
    BodyState below = let_go({x.position, start_.position.y}, {}, law, space);
    const Contact floor = next_contact(below, law, space);
    if (floor.kind == ContactKind::floor) {
        below.position.y = floor.side;
    }
    launch(now, below.position, {x.velocity, 0.0}, law, space, walls_);
}

}  // namespace hyrax
