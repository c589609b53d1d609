// SPDX-License-Identifier: MIT
// What becomes of the energy of a body that should keep it.
#pragma once

#include <iosfwd>

namespace hyrax::bench {

/// The relative error of energy of an elastic, undamped body, per integrator at 60 and 240 Hz, up
/// to `frames` frames: the last one in the table, some on the way in the CSV.
void energy(std::ostream& table, std::ostream& csv, long frames);

}  // namespace hyrax::bench
