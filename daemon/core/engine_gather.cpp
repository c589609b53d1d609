// SPDX-License-Identifier: MIT
// Calls all pets to one place, for whoever has lost sight of them.
#include "daemon/core/engine.h"

#include <algorithm>
#include <vector>

namespace hyrax {

// As many in a row as stand side by side, rows upon rows as far as the place is high: they fall in.
void Engine::gather(const Rect& place) {
    std::vector<PetId> called;
    Size widest{1, 1};
    pets_.for_each([&](PetId id, const Pet& pet) {
        if (pet.motion != Motion::held) {
            called.push_back(id);
            widest.width = std::max(widest.width, box_of(pet).width);
            widest.height = std::max(widest.height, box_of(pet).height);
        }
    });
    if (arena_.empty() || called.empty()) {
        return;
    }
    const auto fitting = static_cast<std::size_t>(std::max(1, place.width / widest.width));
    const std::size_t in_row = std::min(fitting, called.size());
    const double step = static_cast<double>(place.width) / static_cast<double>(in_row);
    for (std::size_t i = 0; i < called.size(); ++i) {
        Pet& pet = *pets_.find(called[i]);
        const double middle = place.x + (static_cast<double>(i % in_row) + 0.5) * step;
        const double row = static_cast<double>(i / in_row) * widest.height;
        const double lowest = std::max(0, place.height - box_of(pet).height);
        this->place(pet, {middle - box_of(pet).width / 2.0, place.y + std::min(row, lowest)});
        launch(called[i], pet, {});
    }
}

}  // namespace hyrax
