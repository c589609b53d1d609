// SPDX-License-Identifier: MIT
// Compares batches with the document's class, bit for bit, over random and special inputs.
#pragma once

#include "physics/batch.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

namespace hyrax {

/// SplitMix64: the same numbers with every compiler and library, unlike those of <random>.
class RandomBits {
public:
    explicit RandomBits(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15;
        std::uint64_t bits = state_;
        bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
        bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
        return bits ^ (bits >> 31);
    }
    /// From 0 to count - 1.
    std::uint64_t below(std::uint64_t count) { return next() % count; }
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
    }
    bool one_in(std::uint64_t count) { return below(count) == 0; }

private:
    std::uint64_t state_;
};

/// Where branches and selections could disagree.
inline constexpr std::array special_numbers{
    0.0,
    -0.0,
    std::numeric_limits<double>::denorm_min(),
    -std::numeric_limits<double>::denorm_min(),
    5.0,
    -8.0,
    1792.0,
    0x1.c02p10,
    1.7e308,
    -1.7e308,
    std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::quiet_NaN(),
};

/// Of NaNs C++ says neither sign nor payload, so one stands for all.
inline bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}
inline bool same_bits(const DocumentState& a, const DocumentState& b) {
    // The short way first: debug builds compare tens of millions.
    return std::memcmp(&a, &b, sizeof a) == 0 || (same_bits(a.x, b.x) && same_bits(a.y, b.y) &&
                                                  same_bits(a.vx, b.vx) && same_bits(a.vy, b.vy));
}

/// The bodies of a batch as objects of the document's class, stepped beside it.
class DocumentTwins {
public:
    explicit DocumentTwins(const PhysicsConstants& constants) : constants_(constants) {}

    void push_back(const DocumentState& body) {
        bodies_.emplace_back(body.x, body.y, body.vx, body.vy).setConstants(constants_);
    }
    void erase(std::size_t index) {
        bodies_[index] = bodies_.back();
        bodies_.pop_back();
    }
    std::size_t size() const { return bodies_.size(); }
    void step(const DocumentFrame& frame) {
        const auto& [dt, screen, object] = frame;
        for (physics& body : bodies_) {
            body.update(dt, screen.width, screen.height, object.width, object.height);
        }
    }
    /// How many bodies of the batch differ from theirs in any bit.
    std::uint64_t differing(const DocumentBatch& batch) const {
        std::uint64_t found = batch.size() == bodies_.size() ? 0 : 1;
        for (std::size_t i = 0; i < bodies_.size() && i < batch.size(); ++i) {
            const physics& twin = bodies_[i];
            const DocumentState expected{twin.x(), twin.y(), twin.vx(), twin.vy()};
            found += same_bits(expected, batch.get(i)) ? 0 : 1;
        }
        return found;
    }

private:
    PhysicsConstants constants_;
    std::vector<physics> bodies_;
};

/// The document's constants, or valid ones at random, their limits among them.
inline PhysicsConstants random_constants(RandomBits& random) {
    if (random.one_in(2)) {
        return {};
    }
    const auto factor = [&random] {
        const double limit = random.one_in(2) ? 0.0 : 1.0;
        return random.one_in(4) ? limit : random.between(0.0, 1.0);
    };
    return {
        .gravity = random.one_in(4) ? 0.0 : random.between(0.0, 5000.0),
        .restitution = factor(),
        .air_drag = factor(),
        .ground_friction = factor(),
        .rest_threshold = random.one_in(4) ? 0.0 : random.between(0.0, 500.0),
    };
}

/// Any step of time, and boxes that may be smaller than the body.
inline DocumentFrame random_frame(RandomBits& random) {
    const std::array steps{
        1.0 / 60.0,
        1.0 / 60.0,
        1.0 / 144.0,
        random.between(0.0, 0.1),
        0.0,
        1e-310,
        1e300,
    };
    const auto length = [&random](std::uint64_t longest) {
        return static_cast<int>(random.below(longest + 1));
    };
    const int largest = random.one_in(4) ? 4000 : 200;
    const auto side = static_cast<std::uint64_t>(largest);
    return {
        .dt = steps[random.below(steps.size())],
        .screen = {length(4000), length(4000)},
        .object = {length(side), length(side)},
    };
}

/// Mostly near and in a box of 4000 px, so that many bodies hit a side in the next frame; some
/// with special numbers, some of arbitrary bits.
inline DocumentState random_body(RandomBits& random) {
    const auto number = [&random](double low, double high) {
        if (random.one_in(16)) {
            return special_numbers[random.below(special_numbers.size())];
        }
        if (random.one_in(32)) {
            return std::bit_cast<double>(random.next());
        }
        return random.between(low, high);
    };
    const double speed = random.one_in(4) ? 20.0 : 4000.0;
    return {
        .x = number(-200.0, 4200.0),
        .y = number(-200.0, 4200.0),
        .vx = number(-speed, speed),
        .vy = number(-speed, speed),
    };
}

/// Steps random batches of up to 70 bodies with the kernel and as objects of the class,
/// `body_steps` steps of one body or a few more, and returns after how many of them a bit differed.
inline std::uint64_t check_identity(Kernel kernel, std::uint64_t body_steps) {
    RandomBits random(20260101);
    std::uint64_t differing = 0;
    for (std::uint64_t done = 0; done < body_steps;) {
        const PhysicsConstants constants = random_constants(random);
        DocumentBatch batch(constants);
        DocumentTwins twins(constants);
        for (std::uint64_t count = 1 + random.below(70); count > 0; --count) {
            const DocumentState body = random_body(random);
            batch.push_back(body);
            twins.push_back(body);
        }
        for (int frames = 0; frames < 16; ++frames) {
            const DocumentFrame frame = random_frame(random);
            batch.step(frame, kernel);
            twins.step(frame);
            differing += twins.differing(batch);
            done += batch.size();
        }
    }
    return differing;
}

}  // namespace hyrax
