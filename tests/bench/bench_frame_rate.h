// SPDX-License-Identifier: MIT
// The same throw at different frame rates.
#pragma once

#include <iosfwd>

namespace hyrax::bench {

/// A drop from 952 px at 600 px/s to the side: the heights of the first three bounces as the frames
/// show them, when the last motion of half a pixel ends and where, per integrator and frame rate.
void frame_rate(std::ostream& table, std::ostream& csv);

}  // namespace hyrax::bench
