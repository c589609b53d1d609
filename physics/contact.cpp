// SPDX-License-Identifier: MIT
#include "physics/contact.h"

#include "physics/flight.h"
#include "physics/time_of_impact.h"

#include <cmath>

namespace hyrax {
namespace {

// True if a point on the line of a side meets the side itself. Its ends belong to whoever moves
// inwards there: corners are met, and a body that slides along a side is not stopped by its end.
bool meets(AxisState along, double acceleration, double low, double high) {
    const auto moves = [&](double direction) {
        return along.velocity * direction > 0.0 ||
               (along.velocity == 0.0 && acceleration * direction > 0.0);
    };
    return (along.offset > low && along.offset < high) || (along.offset == low && moves(1.0)) ||
           (along.offset == high && moves(-1.0));
}

class AirSearch {
public:
    AirSearch(const BodyState& state, const Law& law) : state_(state), law_(law) {}

    void wall(const Obstacle& obstacle) {
        if (state_.velocity.x > 0.0 && state_.position.x <= obstacle.left) {
            wall_at(obstacle, obstacle.left, ContactKind::right_wall);
        } else if (state_.velocity.x < 0.0 && state_.position.x >= obstacle.right) {
            wall_at(obstacle, obstacle.right, ContactKind::left_wall);
        }
    }

    void floor_and_ceiling(const Obstacle& obstacle) {
        const double vy = state_.velocity.y;
        // A floor below the one that is met already cannot be met before it.
        if (obstacle.top != -infinity &&
            (best.kind != ContactKind::floor || obstacle.top < best.side)) {
            const double t =
                fall_time(obstacle.top - state_.position.y, vy, law_.gravity, law_.drag);
            // A body without vertical velocity that lies on a floor already has left it sideways.
            if (t < best.time && (t > 0.0 || vy > 0.0)) {
                level_at(obstacle, t, obstacle.top, ContactKind::floor);
            }
        }
        if (vy < 0.0 && state_.position.y >= obstacle.bottom) {
            const double t =
                rise_time(state_.position.y - obstacle.bottom, -vy, law_.gravity, law_.drag);
            if (t < best.time) {
                level_at(obstacle, t, obstacle.bottom, ContactKind::ceiling);
            }
        }
    }

    Contact best;

private:
    void wall_at(const Obstacle& obstacle, double side, ContactKind kind) {
        const double distance = std::fabs(side - state_.position.x);
        const double t = glide_time(distance, std::fabs(state_.velocity.x), law_.drag);
        if (t < best.time && wall_is_there(obstacle, t)) {
            best = {t, kind, side};
        }
    }

    bool wall_is_there(const Obstacle& obstacle, double t) const {
        if (obstacle.top == -infinity && obstacle.bottom == infinity) {
            return true;
        }
        AxisState y = fly(state_.velocity.y, law_.gravity, law_.drag, t);
        y.offset += state_.position.y;
        return meets(y, law_.gravity, obstacle.top, obstacle.bottom);
    }

    void level_at(const Obstacle& obstacle, double t, double side, ContactKind kind) {
        if (obstacle.left != -infinity || obstacle.right != infinity) {
            AxisState x = glide(state_.velocity.x, law_.drag, t);
            x.offset += state_.position.x;
            if (!meets(x, 0.0, obstacle.left, obstacle.right)) {
                return;
            }
        }
        best = {t, kind, side};
    }

    const BodyState& state_;
    const Law& law_;
};

Contact air_contact(const BodyState& state, const Law& law, const FreeSpace& space, Walls walls) {
    AirSearch search(state, law);
    // Walls first: they cost least, and what is later than the first of them is not looked at.
    if (walls == Walls::meet) {
        for (const Obstacle& obstacle : space.obstacles()) {
            search.wall(obstacle);
        }
    }
    for (const Obstacle& obstacle : space.obstacles()) {
        search.floor_and_ceiling(obstacle);
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
    const Support floor = space.support(state.position).value_or(Support{-infinity, infinity});
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

BodyState free_motion(const BodyState& state, const Law& law, double t) {
    BodyState moved = state;
    if (state.mode == Mode::air && law.drag == 0.0) {
        moved.position.x += state.velocity.x * t;
        moved.position.y += t * (state.velocity.y + 0.5 * law.gravity * t);
        moved.velocity.y += law.gravity * t;
    } else if (state.mode == Mode::air) {
        const PhiFunctions phi = phi_functions(-law.drag * t);
        moved.position.x += state.velocity.x * t * phi.phi1;
        moved.position.y += t * (state.velocity.y * phi.phi1 + law.gravity * t * phi.phi2);
        moved.velocity.x *= phi.exp;
        moved.velocity.y = state.velocity.y * phi.exp + law.gravity * t * phi.phi1;
    } else if (state.mode == Mode::ground) {
        const AxisState x = glide(state.velocity.x, law.ground_drag, t);
        moved.position.x += x.offset;
        moved.velocity.x = x.velocity;
    }
    return moved;
}

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
