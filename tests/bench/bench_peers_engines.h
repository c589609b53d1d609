// SPDX-License-Identifier: MIT
// The engines one by one: each in a file that is compiled where its headers are.
#pragma once

#include "tests/bench/bench_peers.h"

namespace hyrax::bench {

/// Nothing where this program was built without the engine. Each is used as its manual has it:
/// its own step at 60 Hz, positions read after each.
std::unique_ptr<Peer> make_box2d(const PeerScene& scene);
std::unique_ptr<Peer> make_chipmunk(const PeerScene& scene);
std::unique_ptr<Peer> make_rapier(const PeerScene& scene);

}  // namespace hyrax::bench
