// SPDX-License-Identifier: MIT
// The stability catalogue as a report.
#pragma once

#include <iosfwd>

namespace hyrax::bench {

/// A row for each case, a column for each integrator, failures in brackets with their measured
/// value, and their number in the last row; the same for machines.
void stability(std::ostream& table, std::ostream& csv);

}  // namespace hyrax::bench
