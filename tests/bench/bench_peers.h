// SPDX-License-Identifier: MIT
// General physics engines on the scene that this project is made for.
#pragma once

#include "physics/geometry.h"

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace hyrax::bench {

struct PeerBody {
    Vec2 position;  ///< Top-left corner [px].
    Vec2 velocity;  ///< [px/s]
};

inline constexpr int peer_side = 128;  ///< Of each body [px].
inline constexpr double peer_frame = 1.0 / 60.0;

/// Boxes in the four walls of a screen, which never hit each other and never come to rest.
struct PeerScene {
    Size screen;
    std::vector<PeerBody> bodies;
};

/// One engine with its bodies.
class Peer {
public:
    Peer() = default;
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;
    virtual ~Peer() = default;

    virtual std::string name() const = 0;
    /// Puts all bodies back to where they started.
    virtual void reset() = 0;
    /// So many frames at 60 Hz; returns the sum of all coordinates at each, which a frame reads.
    virtual double run(int frames) = 0;
};

/// Nanoseconds of a body and step for 100, 1000 and 10 000 bodies, on a screen of 1920 x 1080 and
/// on ones with ten and a hundred times its area: general engines pay for each overlap that their
/// filter then drops, so that on one screen the crowd's density would be what is measured. With the
/// ratio to the default integrator of this project, all in turns in one run.
void peers(std::ostream& table, std::ostream& csv, double seconds_per_cell);

}  // namespace hyrax::bench
