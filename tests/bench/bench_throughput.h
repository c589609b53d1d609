// SPDX-License-Identifier: MIT
// How long the document's step takes: the class, each kernel of a batch, and the memory alone.
#pragma once

#include <iosfwd>

namespace hyrax {

/// Writes the median nanoseconds of a pet and step for 1 to 1 000 000 pets in flight: a table of
/// figures with ratios to the class, and the same as CSV. Each of about 36 cells takes about
/// `seconds_per_cell`, the last row more if that is below 0.5. Compare figures of one run alone.
void throughput(std::ostream& table, std::ostream& csv, double seconds_per_cell);

}  // namespace hyrax
