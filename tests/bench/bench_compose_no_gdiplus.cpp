// SPDX-License-Identifier: MIT
#include "tests/bench/bench_compose.h"

namespace hyrax::bench {

Composer gdiplus_composer() {
    return {};
}

}  // namespace hyrax::bench
