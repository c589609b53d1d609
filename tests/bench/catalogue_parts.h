// SPDX-License-Identifier: MIT
// The catalogue's cases by subject, each in a file of its own.
#pragma once

#include "tests/bench/catalogue.h"

namespace hyrax::bench {

std::span<const CatalogueCase> flight_cases();
std::span<const CatalogueCase> impact_cases();
std::span<const CatalogueCase> rest_cases();
std::span<const CatalogueCase> time_cases();
std::span<const CatalogueCase> bounds_cases();

}  // namespace hyrax::bench
