// SPDX-License-Identifier: MIT
// One step of each integrator that goes from frame to frame. They share the law, the space and the
// rules of contact, and differ in how they fly and in whether they locate an impact inside a step.
#pragma once

#include "physics/contact.h"

#include <vector>

namespace hyrax {

/// A contact and the speed towards its side [px/s].
struct Impact {
    Contact contact;
    double speed = 0.0;
};

/// Gravity, drag, position, then collisions at the end of the step: the document's scheme with
/// rates in place of multipliers and with a state of rest. First order. Impacts are noticed, not
/// located, and a rebound must be quicker than one step of gravity to leave the floor.
BodyState step_semi_implicit_euler(
    BodyState state, const Law& law, const FreeSpace& space, double dt, std::vector<Impact>& impacts
);

/// The exact flight over one step, with every impact in it located.
BodyState step_exponential_swept(
    BodyState state, const Law& law, const FreeSpace& space, double dt, std::vector<Impact>& impacts
);

/// Stoermer-Verlet: half of the drag, a parabola that is swept against the space, half of the drag
/// (Strang splitting). Second order.
BodyState step_stormer_verlet(
    BodyState state, const Law& law, const FreeSpace& space, double dt, std::vector<Impact>& impacts
);

/// Contacts after which a step gives up and puts the body at rest where it is.
inline constexpr int most_contacts_in_step = 4096;

}  // namespace hyrax
