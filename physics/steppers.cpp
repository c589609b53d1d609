// SPDX-License-Identifier: MIT
#include "physics/steppers.h"

#include <algorithm>
#include <cmath>

namespace hyrax {
namespace {

bool is_wall(ContactKind kind) {
    return kind == ContactKind::left_wall || kind == ContactKind::right_wall;
}

BodyState meet(
    const Contact& contact,
    const BodyState& arriving,
    const Law& law,
    const FreeSpace& space,
    std::vector<Impact>& impacts
) {
    const Vec2 v = arriving.velocity;
    impacts.push_back({contact, std::fabs(is_wall(contact.kind) ? v.x : v.y)});
    BodyState state = after_contact(contact, arriving, law, space);
    state.position = space.nearest(state.position);
    return state;
}

BodyState exhausted(BodyState state) {
    state.velocity = {};
    state.mode = Mode::rest;
    return state;
}

// Exact motion over `dt`, contact by contact.
BodyState sweep(
    BodyState state, const Law& law, const FreeSpace& space, double dt, std::vector<Impact>& impacts
) {
    for (int contacts = 0; contacts < most_contacts_in_step; ++contacts) {
        const Contact contact = next_contact(state, law, space);
        const double from_y = state.position.y;
        BodyState moved = free_motion(state, law, std::min(contact.time, dt));
        moved.position = space.above_ledges(from_y, moved.position);
        if (contact.time > dt) {
            return moved;
        }
        state = meet(contact, moved, law, space, impacts);
        dt -= contact.time;
    }
    return exhausted(state);
}

// Where the flight of one step may lead: it never rises above the straight line of its start.
bool may_meet_something(
    const BodyState& from, const BodyState& to, const FreeSpace& space, double dt
) {
    const double left = std::min(from.position.x, to.position.x);
    const double right = std::max(from.position.x, to.position.x);
    const double bottom = std::max(from.position.y, to.position.y);
    const double rise = std::min(0.0, from.velocity.y * dt);
    const double top = std::min(from.position.y + rise, to.position.y);
    return std::ranges::any_of(
               space.obstacles(),
               [&](const Obstacle& o) {
                   return right >= o.left && left <= o.right && bottom >= o.top && top <= o.bottom;
               }
           ) ||
           std::ranges::any_of(space.ledges(), [&](const Barrier& ledge) {
               return right >= ledge.low && left <= ledge.high && bottom >= ledge.at &&
                      top <= ledge.at;
           });
}

// The axes one after the other, as the document has it: x along the old height, then y.
struct Blocked {
    bool hit = false;
    double side = 0.0;
};

Blocked blocked_x(Vec2 from, double to, const FreeSpace& space) {
    for (const Obstacle& o : space.obstacles()) {
        if (o.contains({to, from.y})) {
            return {true, to > from.x ? o.left : o.right};
        }
    }
    return {};
}

Blocked blocked_y(Vec2 from, double to, const FreeSpace& space) {
    Blocked found;
    for (const Barrier& ledge : space.ledges()) {
        const bool crosses = from.y <= ledge.at && to > ledge.at;
        if (crosses && from.x > ledge.low && from.x < ledge.high &&
            !(found.hit && found.side <= ledge.at)) {
            found = {true, ledge.at};
        }
    }
    for (const Obstacle& o : space.obstacles()) {
        if (o.contains({from.x, to})) {
            const double side = to > from.y ? o.top : o.bottom;
            return found.hit && found.side < side ? found : Blocked{true, side};
        }
    }
    return found;
}

BodyState euler_slide(
    BodyState state, const Law& law, const FreeSpace& space, double dt, std::vector<Impact>& impacts
) {
    state.velocity.x *= std::exp(-law.ground_drag * dt);
    const double x = state.position.x + state.velocity.x * dt;
    if (const Blocked wall = blocked_x(state.position, x, space); wall.hit) {
        const auto kind = state.velocity.x > 0 ? ContactKind::right_wall : ContactKind::left_wall;
        return meet({dt, kind, wall.side}, state, law, space, impacts);
    }
    state.position.x = x;
    if (!space.support(state.position)) {
        return meet({dt, ContactKind::edge, x}, state, law, space, impacts);
    }
    if (std::fabs(state.velocity.x) <= law.stop_speed) {
        return meet({dt, ContactKind::stop, 0.0}, state, law, space, impacts);
    }
    return state;
}

BodyState euler_fly(
    BodyState state, const Law& law, const FreeSpace& space, double dt, std::vector<Impact>& impacts
) {
    const double kept = std::exp(-law.drag * dt);
    state.velocity.y += law.gravity * dt;
    state.velocity = state.velocity * kept;
    const Vec2 to = state.position + state.velocity * dt;
    const Blocked wall = blocked_x(state.position, to.x, space);
    if (wall.hit) {
        const auto kind = state.velocity.x > 0 ? ContactKind::right_wall : ContactKind::left_wall;
        state = meet({dt, kind, wall.side}, state, law, space, impacts);
    } else {
        state.position.x = to.x;
    }
    const Blocked level = blocked_y(state.position, to.y, space);
    if (level.hit) {
        // A step of gravity would throw a slower rebound back at once, for ever.
        Law stepped = law;
        stepped.rest_speed = std::max(law.rest_speed, law.gravity * dt);
        const auto kind = state.velocity.y > 0 ? ContactKind::floor : ContactKind::ceiling;
        state = meet({dt, kind, level.side}, state, stepped, space, impacts);
    } else {
        state.position.y = to.y;
    }
    const double speed = std::hypot(state.velocity.x, state.velocity.y);
    if (law.gravity == 0.0 && law.drag > 0.0 && speed <= law.stop_speed) {
        return exhausted(state);
    }
    return state;
}

}  // namespace

BodyState step_semi_implicit_euler(
    BodyState state, const Law& law, const FreeSpace& space, double dt, std::vector<Impact>& impacts
) {
    switch (state.mode) {
        case Mode::air:
            return euler_fly(state, law, space, dt, impacts);
        case Mode::ground:
            return euler_slide(state, law, space, dt, impacts);
        case Mode::rest:
            break;
    }
    return state;
}

BodyState step_exponential_swept(
    BodyState state, const Law& law, const FreeSpace& space, double dt, std::vector<Impact>& impacts
) {
    if (state.mode == Mode::air && law.gravity > 0.0) {
        const BodyState to = free_motion(state, law, dt);
        if (!may_meet_something(state, to, space, dt)) {
            return to;
        }
    }
    return sweep(state, law, space, dt, impacts);
}

BodyState step_stormer_verlet(
    BodyState state, const Law& law, const FreeSpace& space, double dt, std::vector<Impact>& impacts
) {
    Law undamped = law;
    undamped.drag = 0.0;
    for (int contacts = 0; contacts < most_contacts_in_step; ++contacts) {
        if (state.mode != Mode::air) {
            return sweep(state, law, space, dt, impacts);
        }
        const Vec2 before = state.velocity;
        BodyState flight = state;
        flight.velocity = state.velocity * std::exp(-law.drag * dt / 2.0);
        // Half of the drag of a long step may leave nothing of it, and a body without vertical
        // velocity that lies on a floor would count as having left it sideways.
        if (flight.velocity.y == 0.0 && before.y != 0.0) {
            flight.velocity.y = std::copysign(1e-300, before.y);
        }
        const Contact contact = next_contact(flight, undamped, space);
        const double t = std::min(contact.time, dt);
        state = free_motion(flight, undamped, t);
        state.position = space.above_ledges(flight.position.y, state.position);
        // For a whole step, half of the drag before gravity and half of it after; for a flight
        // that ends early as much as its time is worth.
        const double kept = std::exp(-law.drag * t);
        state.velocity.x = before.x * kept;
        state.velocity.y = before.y * kept + law.gravity * t * std::exp(-law.drag * t / 2.0);
        if (contact.time > dt) {
            const double speed = std::hypot(state.velocity.x, state.velocity.y);
            const bool drifts = law.gravity == 0.0 && law.drag > 0.0 && speed <= law.stop_speed;
            return drifts ? exhausted(state) : state;
        }
        state = meet(contact, state, law, space, impacts);
        dt -= t;
    }
    return exhausted(state);
}

}  // namespace hyrax
