// SPDX-License-Identifier: MIT
// The document's model: one point mass in a box, stepped once per frame by semi-implicit Euler.
#pragma once

namespace hyrax {

/// The document's constants, held per instance so that a config file can tune them.
/// Valid: every value finite; gravity and rest_threshold >= 0; the three factors from 0 to 1.
struct PhysicsConstants {
    double gravity = 1200.0;   ///< Downward acceleration [px/s^2].
    double restitution = 0.6;  ///< Speed kept by an impact, a ratio of velocities.
    double air_drag = 0.999;   ///< Velocity kept by each frame.
    double ground_friction =
        0.8;  ///< Horizontal velocity kept by each frame that touches the ground.
    double rest_threshold = 5.0;  ///< Rebounds slower than this stop [px/s].

    bool operator==(const PhysicsConstants&) const = default;
};

/// A body as the document defines it (sections 2 to 6): position [px], velocity [px/s], y down.
/// The position is the top-left corner of the object's box; see docs/physics.md for the places
/// where the document's text and code disagree. Never fails: callers pass finite numbers.
class physics {
public:
    static constexpr double GRAVITY = PhysicsConstants{}.gravity;
    static constexpr double RESTITUTION = PhysicsConstants{}.restitution;
    static constexpr double AIR_DRAG = PhysicsConstants{}.air_drag;
    static constexpr double GROUND_FRICTION = PhysicsConstants{}.ground_friction;
    static constexpr double REST_THRESHOLD = PhysicsConstants{}.rest_threshold;

    physics();
    physics(double x, double y, double vx = 0.0, double vy = 0.0);

    /// One frame: gravity, drag, position, collisions, in the document's order of operations.
    /// dt is the time since the previous frame [s]; the box is [0, screen - object] on each axis.
    void update(
        double dt, int screen_width, int screen_height, int object_width, int object_height
    );

    double x() const { return x_; }
    double y() const { return y_; }
    double vx() const { return vx_; }
    double vy() const { return vy_; }
    void setPos(double x, double y);
    void setVelocity(double vx, double vy);
    void resetVelocity();

    const PhysicsConstants& constants() const { return constants_; }
    /// Takes effect with the next update.
    void setConstants(const PhysicsConstants& constants) { constants_ = constants; }

private:
    PhysicsConstants constants_;
    double x_, y_;
    double vx_, vy_;
};

}  // namespace hyrax
