// SPDX-License-Identifier: MIT
#include "physics/contact.h"

#include "physics/flight.h"
#include "physics/time_of_impact.h"

#include <cmath>
#include <span>

namespace hyrax {
namespace {

// Roundings may put a body that aims at a corner past both of its sides, and so into the solid: the
// wall takes it [px].
constexpr double corner_slack = 1e-9;

// True if a point on the line of a side meets the side itself. Its ends belong to whoever moves
// inwards there, within `slack`: corners are met, and a body that slides along a side is not
// stopped by its end.
bool meets(AxisState along, double acceleration, const Barrier& side, double slack) {
    const auto moves = [&](double direction) {
        return along.velocity * direction > 0.0 ||
               (along.velocity == 0.0 && acceleration * direction > 0.0);
    };
    const double at = along.offset;
    return (at > side.low && at < side.high) ||
           (at <= side.low && at >= side.low - slack && moves(1.0)) ||
           (at >= side.high && at <= side.high + slack && moves(-1.0));
}

class AirSearch {
public:
    AirSearch(const BodyState& state, const Law& law) : state_(state), law_(law) {}

    void floors(std::span<const Barrier> sides) {
        const double vy = state_.velocity.y;
        for (const Barrier& side : sides) {
            // One below the floor that is met already cannot be met before it.
            if (best.kind == ContactKind::floor && side.at >= best.side) {
                continue;
            }
            const double t = fall_time(side.at - state_.position.y, vy, law_.gravity, law_.drag);
            // A body without vertical velocity that lies on a floor already has left it sideways.
            if (t < best.time && (t > 0.0 || vy != 0.0) && reaches(side, t)) {
                best = {t, ContactKind::floor, side.at};
            }
        }
    }

    void ceilings(std::span<const Barrier> sides) {
        const double rising = -state_.velocity.y;
        for (const Barrier& side : sides) {
            const double height = state_.position.y - side.at;
            if (height >= 0.0) {
                const double t = rise_time(height, rising, law_.gravity, law_.drag);
                if (t < best.time && reaches(side, t)) {
                    best = {t, ContactKind::ceiling, side.at};
                }
            }
        }
    }

    // `direction`: 1 for walls on the right, -1 for walls on the left.
    void walls(std::span<const Barrier> sides, double direction, ContactKind kind) {
        const double speed = direction * state_.velocity.x;
        for (const Barrier& side : sides) {
            const double distance = direction * (side.at - state_.position.x);
            // Drag makes it later than a uniform motion, which costs no logarithm.
            if (distance < 0.0 || distance >= best.time * speed) {
                continue;
            }
            const double t = glide_time(distance, speed, law_.drag);
            if (t < best.time && is_hit(side, t)) {
                best = {t, kind, side.at};
            }
        }
    }

    Contact best;

private:
    bool is_hit(const Barrier& wall, double t) const {
        if (wall.low == -infinity && wall.high == infinity) {
            return true;
        }
        AxisState y = fly(state_.velocity.y, law_.gravity, law_.drag, t);
        y.offset += state_.position.y;
        return meets(y, law_.gravity, wall, corner_slack);
    }

    bool reaches(const Barrier& level, double t) const {
        if (level.low == -infinity && level.high == infinity) {
            return true;
        }
        AxisState x = glide(state_.velocity.x, law_.drag, t);
        x.offset += state_.position.x;
        return meets(x, 0.0, level, 0.0);
    }

    const BodyState& state_;
    const Law& law_;
};

Contact air_contact(const BodyState& state, const Law& law, const FreeSpace& space, Walls walls) {
    AirSearch search(state, law);
    search.floors(space.floors());
    if (state.velocity.y < 0.0) {
        search.ceilings(space.ceilings());
    }
    if (walls == Walls::meet && state.velocity.x > 0.0) {
        search.walls(space.right_walls(), 1.0, ContactKind::right_wall);
    } else if (walls == Walls::meet && state.velocity.x < 0.0) {
        search.walls(space.left_walls(), -1.0, ContactKind::left_wall);
    }
    if (law.gravity == 0.0 && law.drag > 0.0) {
        const double speed = std::hypot(state.velocity.x, state.velocity.y);
        const double t = decay_time(speed, law.stop_speed, law.drag);
        if (t < search.best.time) {
            search.best = {t, ContactKind::stop, 0.0};
        }
    }
    return search.best;
}

Contact ground_contact(const BodyState& state, const Law& law, const FreeSpace& space) {
    const bool to_the_right = state.velocity.x > 0.0;
    const double speed = std::fabs(state.velocity.x);
    Contact best{decay_time(speed, law.stop_speed, law.ground_drag), ContactKind::stop, 0.0};
    const auto consider = [&](ContactKind kind, double side) {
        const double distance = to_the_right ? side - state.position.x : state.position.x - side;
        const double t = glide_time(std::fmax(distance, 0.0), speed, law.ground_drag);
        if (t < best.time) {
            best = {t, kind, side};
        }
    };
    const Support walls = space.corridor(state.position);
    // A corner that was met exactly is no part of the floor, but what lies before the body is.
    const double ahead = std::nextafter(state.position.x, to_the_right ? infinity : -infinity);
    const Support floor = space.support({ahead, state.position.y})
                              .value_or(Support{state.position.x, state.position.x});
    if (to_the_right) {
        consider(ContactKind::right_wall, walls.right);
        consider(ContactKind::edge, floor.right);
    } else {
        consider(ContactKind::left_wall, walls.left);
        consider(ContactKind::edge, floor.left);
    }
    return best;
}

BodyState at_rest(BodyState state) {
    state.velocity = {};
    state.mode = Mode::rest;
    return state;
}

// Drag without gravity is left to the stop event: here only what can never move again.
BodyState stopped_if_slow(BodyState state, const Law& law) {
    const bool slow = state.mode == Mode::ground && std::fabs(state.velocity.x) <= law.stop_speed;
    const bool floats = law.gravity == 0.0 && state.velocity == Vec2{};
    return slow || floats ? at_rest(state) : state;
}

BodyState after_wall(
    BodyState state, const Contact& contact, const Law& law, const FreeSpace& space
) {
    state.position.x = contact.side;
    state.velocity.x *= -law.restitution;
    // A corridor of no width would answer with the other wall at once, for ever.
    if (contact.time == 0.0) {
        const Support walls = space.corridor(state.position);
        if (walls.left == walls.right) {
            state.velocity.x = 0.0;
        }
    }
    return stopped_if_slow(state, law);
}

BodyState after_floor(BodyState state, const Contact& contact, const Law& law) {
    state.position.y = contact.side;
    state.velocity.x *= law.impact_friction;
    const double rebound = law.restitution * state.velocity.y;
    if (rebound >= law.rest_speed) {
        state.velocity.y = -rebound;
        return state;
    }
    state.velocity.y = 0.0;
    if (law.gravity > 0.0) {
        state.mode = Mode::ground;
    }
    return stopped_if_slow(state, law);
}

}  // namespace

Contact next_contact(const BodyState& state, const Law& law, const FreeSpace& space, Walls walls) {
    switch (state.mode) {
        case Mode::air:
            return air_contact(state, law, space, walls);
        case Mode::ground:
            return ground_contact(state, law, space);
        case Mode::rest:
            break;
    }
    return {};
}

BodyState after_contact(
    const Contact& contact, BodyState arriving, const Law& law, const FreeSpace& space
) {
    switch (contact.kind) {
        case ContactKind::none:
            return arriving;
        case ContactKind::left_wall:
        case ContactKind::right_wall:
            return after_wall(arriving, contact, law, space);
        case ContactKind::ceiling:
            arriving.position.y = contact.side;
            arriving.velocity.y *= -law.restitution;
            // A room as high as the body has its floor here.
            if (arriving.velocity.y == 0.0 && law.gravity > 0.0 &&
                space.support(arriving.position)) {
                arriving.mode = Mode::ground;
            }
            return stopped_if_slow(arriving, law);
        case ContactKind::floor:
            return after_floor(arriving, contact, law);
        case ContactKind::edge:
            arriving.position.x = contact.side;
            arriving.mode = Mode::air;
            return arriving;
        case ContactKind::stop:
            return at_rest(arriving);
    }
    return arriving;
}

BodyState let_go(Vec2 position, Vec2 velocity, const Law& law, const FreeSpace& space) {
    BodyState state{space.nearest(position), velocity, Mode::air};
    if (law.gravity == 0.0) {
        const double speed = std::hypot(velocity.x, velocity.y);
        const bool slow = law.drag > 0.0 ? speed <= law.stop_speed : speed == 0.0;
        return slow ? at_rest(state) : state;
    }
    if (velocity.y == 0.0 && space.support(state.position)) {
        state.mode = Mode::ground;
    }
    return stopped_if_slow(state, law);
}

}  // namespace hyrax
