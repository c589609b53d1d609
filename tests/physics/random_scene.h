// SPDX-License-Identifier: MIT
// Random laws, spaces and throws that are the same everywhere, and a body that runs through one.
#pragma once

#include "physics/trajectory.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <utility>
#include <vector>

namespace hyrax::test {

/// The distributions of the library differ from one to the next, its engine does not.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// From 0 to count - 1.
    std::uint64_t below(std::uint64_t count) { return engine_() % count; }
    bool one_in(std::uint64_t count) { return below(count) == 0; }
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    /// Even in the logarithm, 0 < low.
    double scale(double low, double high) {
        return std::exp(between(std::log(low), std::log(high)));
    }
    int whole(int low, int high) {
        return low + static_cast<int>(below(static_cast<std::uint64_t>(high - low) + 1));
    }
    Ticks ticks(Ticks most) {
        return static_cast<Ticks>(below(static_cast<std::uint64_t>(most) + 1));
    }
    double pick(std::initializer_list<double> choices) {
        return *(choices.begin() + below(choices.size()));
    }

private:
    std::mt19937_64 engine_;
};

/// A body that is let go.
struct Scene {
    Law law;
    FreeSpace space;
    Vec2 position;
    Vec2 velocity;
};

/// The document's law, or one that is far from it.
inline Law random_law(Random& random) {
    if (random.one_in(3)) {
        return law_from({});
    }
    Law law{
        .gravity = random.pick({0.0, 300.0, 1200.0, 1200.0, 9000.0, 1e6}),
        .drag = random.pick({0.0, 0.0, 1e-12, 1e-6, 0.06, 0.5, 20.0}),
        .restitution = random.pick({0.0, 0.3, 0.6, 0.6, 0.9, 1.0}),
        .impact_friction = random.pick({0.0, 0.5, 0.8, 0.8, 1.0}),
        .stop_speed = 5.0,
    };
    law.ground_drag = law.drag + random.pick({0.0, 0.5, 13.4});
    law.rest_speed = std::max(5.0, std::sqrt(2.0 * law.gravity * visible_hop));
    return law;
}

/// Nothing is lost: what comes up must come down to where it was.
inline Law elastic_law(double gravity) {
    return {.gravity = gravity, .restitution = 1.0, .impact_friction = 1.0};
}

inline FreeSpace random_box(Random& random) {
    const double left = random.whole(-4000, 4000);
    const double top = random.whole(-4000, 4000);
    const double width = random.whole(200, 3000);
    const double height = random.whole(200, 2000);
    return FreeSpace::box(left, top, left + width, top + height);
}

/// One to four monitors, each of which shares a part of a side with an earlier one.
inline std::vector<Rect> random_rooms(Random& random) {
    std::vector<Rect> rooms{
        {random.whole(-3000, 3000),
         random.whole(-3000, 3000),
         random.whole(600, 2600),
         random.whole(500, 1500)}
    };
    const int count = random.whole(1, 4);
    while (static_cast<int>(rooms.size()) < count) {
        const Rect beside = rooms[random.below(rooms.size())];
        Rect room{0, 0, random.whole(600, 2600), random.whole(500, 1500)};
        if (random.one_in(2)) {
            room.x = random.one_in(2) ? beside.right() : beside.x - room.width;
            room.y = random.whole(beside.y - room.height + 200, beside.bottom() - 200);
        } else {
            room.y = random.one_in(2) ? beside.bottom() : beside.y - room.height;
            room.x = random.whole(beside.x - room.width + 200, beside.right() - 200);
        }
        rooms.push_back(room);
    }
    return rooms;
}

/// For a body of any size among them.
inline FreeSpace random_arena(Random& random) {
    const Size box{random.whole(16, 200), random.whole(16, 200)};
    return FreeSpace::among(random_rooms(random), box);
}

/// A velocity in any direction, its size even in the logarithm [px/s].
inline Vec2 random_velocity(Random& random, double slowest, double quickest) {
    const double speed = random.scale(slowest, quickest);
    const double x = random.between(-1.0, 1.0);
    return {speed * x, (random.one_in(2) ? -speed : speed) * std::sqrt(1.0 - x * x)};
}

inline Vec2 random_place(Random& random, const FreeSpace& space) {
    return space.nearest({random.between(-5000.0, 6000.0), random.between(-5000.0, 6000.0)});
}

inline Scene random_scene(Random& random, bool one_box = false) {
    Scene scene;
    scene.law = random_law(random);
    scene.space = one_box || random.one_in(2) ? random_box(random) : random_arena(random);
    scene.position = random_place(random, scene.space);
    scene.velocity = random_velocity(random, 10.0, 1e4);
    if (random.one_in(4)) {
        scene.velocity.y = 0.0;
    }
    return scene;
}

/// A trajectory together with what it moves in.
class Run {
public:
    explicit Run(Scene scene, WallEvents walls = WallEvents::wanted) : scene_(std::move(scene)) {
        body_.launch(0, scene_.position, scene_.velocity, scene_.law, scene_.space, walls);
    }

    BodyState at(Ticks now) {
        body_.advance(now, scene_.law, scene_.space, [this](const TrajectoryEvent& event) {
            events.push_back(event);
        });
        return body_.at(now, scene_.law, scene_.space);
    }
    Trajectory& body() { return body_; }

    std::vector<TrajectoryEvent> events;

private:
    Scene scene_;
    Trajectory body_;
};

inline bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline bool same_bits(const BodyState& a, const BodyState& b) {
    return same_bits(a.position.x, b.position.x) && same_bits(a.position.y, b.position.y) &&
           same_bits(a.velocity.x, b.velocity.x) && same_bits(a.velocity.y, b.velocity.y) &&
           a.mode == b.mode;
}

inline double distance(Vec2 a, Vec2 b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// How deep the point lies inside a solid [px]; 0 outside, infinite for what is no number.
inline double depth_inside(const FreeSpace& space, Vec2 p) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
        return infinity;
    }
    double deepest = 0.0;
    for (const Obstacle& o : space.obstacles()) {
        const double depth = std::min({p.x - o.left, o.right - p.x, p.y - o.top, o.bottom - p.y});
        deepest = std::max(deepest, depth);
    }
    return deepest;
}

/// v^2 / 2 - G y [px^2/s^2].
inline double energy(const BodyState& state, const Law& law) {
    return 0.5 * (state.velocity.x * state.velocity.x + state.velocity.y * state.velocity.y) -
           law.gravity * state.position.y;
}

/// Of numbers; the lowest byte first (FNV-1a).
class Hash {
public:
    void add(std::uint64_t bits) {
        for (int byte = 0; byte < 8; ++byte, bits >>= 8) {
            value_ = (value_ ^ (bits & 0xff)) * 0x100000001b3;
        }
    }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace hyrax::test
