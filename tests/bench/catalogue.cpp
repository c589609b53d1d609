// SPDX-License-Identifier: MIT
#include "tests/bench/catalogue.h"

#include "tests/bench/catalogue_parts.h"

#include <algorithm>
#include <vector>

namespace hyrax::bench {

std::span<const CatalogueCase> catalogue() {
    static const std::vector<CatalogueCase> cases = [] {
        std::vector<CatalogueCase> all;
        for (const auto part :
             {flight_cases(), impact_cases(), rest_cases(), time_cases(), bounds_cases()}) {
            all.insert(all.end(), part.begin(), part.end());
        }
        std::ranges::sort(all, {}, &CatalogueCase::id);
        return all;
    }();
    return cases;
}

}  // namespace hyrax::bench
