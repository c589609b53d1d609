// SPDX-License-Identifier: MIT
#include "tests/bench/bench_peers_engines.h"

namespace hyrax::bench {

std::unique_ptr<Peer> make_chipmunk(const PeerScene&) {
    return nullptr;
}

}  // namespace hyrax::bench
