// SPDX-License-Identifier: MIT
#include "daemon/core/collisions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace hyrax {
namespace {

Vec2 middle(const CollisionBox& box) {
    return box.position + Vec2{box.size.width / 2.0, box.size.height / 2.0};
}

bool comes_before(const std::pair<PetId, PetId>& x, const std::pair<PetId, PetId>& y) {
    const auto key = [](const std::pair<PetId, PetId>& pair) {
        return std::array{
            pair.first.index, pair.second.index, pair.first.generation, pair.second.generation
        };
    };
    return key(x) < key(y);
}

}  // namespace

bool overlap(const CollisionBox& a, const CollisionBox& b) {
    return a.left() < b.right() && b.left() < a.right() && a.top() < b.bottom() &&
           b.top() < a.bottom();
}

double closing_speed(const CollisionBox& a, const CollisionBox& b) {
    const Vec2 apart = middle(b) - middle(a);
    const Vec2 towards = a.velocity - b.velocity;
    const double distance = std::hypot(apart.x, apart.y);
    if (distance <= 0.0) {
        return std::hypot(towards.x, towards.y);
    }
    return std::max(0.0, (towards.x * apart.x + towards.y * apart.y) / distance);
}

void Collisions::begin(std::size_t count) {
    boxes_.clear();
    boxes_.reserve(count);
}

// A box can only meet those whose left side lies before its right side.
std::span<const Collision> Collisions::find() {
    order_.resize(boxes_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::sort(order_, {}, [this](std::size_t i) { return boxes_[i].left(); });
    pairs_.clear();
    for (std::size_t i = 0; i < order_.size(); ++i) {
        const double right = boxes_[order_[i]].right();
        for (std::size_t j = i + 1; j < order_.size() && boxes_[order_[j]].left() < right; ++j) {
            if (overlap(boxes_[order_[i]], boxes_[order_[j]])) {
                pairs_.push_back({std::min(order_[i], order_[j]), std::max(order_[i], order_[j])});
            }
        }
    }
    std::ranges::sort(pairs_, [](const Pair& x, const Pair& y) {
        return std::pair(x.first, x.second) < std::pair(y.first, y.second);
    });

    found_.clear();
    now_.clear();
    for (const Pair& pair : pairs_) {
        const CollisionBox& a = boxes_[pair.first];
        const CollisionBox& b = boxes_[pair.second];
        now_.emplace_back(a.pet, b.pet);
        if (!first_ && !std::ranges::binary_search(before_, now_.back(), comes_before)) {
            found_.push_back({a.pet, b.pet, closing_speed(a, b)});
        }
    }
    std::swap(before_, now_);
    first_ = false;
    return found_;
}

void Collisions::forget() {
    before_.clear();
    first_ = true;
}

}  // namespace hyrax
