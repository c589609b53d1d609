// SPDX-License-Identifier: MIT
#include "tests/bench/bench_peers_engines.h"

namespace hyrax::bench {

std::unique_ptr<Peer> make_rapier(const PeerScene&) {
    return nullptr;
}

}  // namespace hyrax::bench
