// SPDX-License-Identifier: MIT
// Which pets have begun to touch since the frame before: sort and sweep along x (Baraff 1992).
#pragma once

#include "daemon/core/pet.h"
#include "physics/geometry.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace hyrax {

struct CollisionBox {
    PetId pet;
    Vec2 position;  ///< Top-left corner [px].
    Size size;
    Vec2 velocity;  ///< [px/s]

    double left() const { return position.x; }
    double right() const { return position.x + size.width; }
    double top() const { return position.y; }
    double bottom() const { return position.y + size.height; }
};

/// True if the boxes share more than an edge.
bool overlap(const CollisionBox& a, const CollisionBox& b);
/// How fast the middles of the boxes come nearer, 0 if they do not [px/s].
double closing_speed(const CollisionBox& a, const CollisionBox& b);

struct Collision {
    PetId a;  ///< The one with the smaller index.
    PetId b;
    double speed = 0.0;  ///< closing_speed()
};

/// Use: begin(), add() for each pet in the order of their indices, find(). Keeps its memory.
class Collisions {
public:
    void begin(std::size_t count);
    void add(const CollisionBox& box) { boxes_.push_back(box); }
    /// The pairs that overlap now and did not at the last call, by a, then b; none at the first
    /// call. Valid until the next one.
    std::span<const Collision> find();
    /// The next find() is a first one.
    void forget();

private:
    struct Pair {
        std::size_t first;  // Index into boxes_.
        std::size_t second;
    };

    std::vector<CollisionBox> boxes_;
    std::vector<std::size_t> order_;  // Indices into boxes_, by left side.
    std::vector<std::pair<PetId, PetId>> before_;
    std::vector<std::pair<PetId, PetId>> now_;
    std::vector<Pair> pairs_;
    std::vector<Collision> found_;
    bool first_ = true;
};

}  // namespace hyrax
