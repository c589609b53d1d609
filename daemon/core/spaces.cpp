// SPDX-License-Identifier: MIT
#include "daemon/core/spaces.h"

#include "daemon/core/check.h"

#include <algorithm>

namespace hyrax {

void Spaces::set_arena(const Arena& arena) {
    arena_ = arena;
    for (Entry& entry : entries_) {
        if (entry.users > 0) {
            entry.space = arena_.space_for(entry.box);
        } else {
            entry = {};  // No pet has an empty box: nobody finds it, and it may be taken.
        }
    }
}

std::size_t Spaces::acquire(Size box) {
    auto found = std::ranges::find(entries_, box, &Entry::box);
    if (found == entries_.end()) {
        found = std::ranges::find(entries_, std::size_t{0}, &Entry::users);
        if (found == entries_.end()) {
            found = entries_.insert(entries_.end(), Entry{});
        }
        *found = {.box = box, .users = 0, .space = arena_.space_for(box)};
    }
    ++found->users;
    return static_cast<std::size_t>(found - entries_.begin());
}

void Spaces::release(std::size_t index) {
    HYRAX_CHECK(index < entries_.size() && entries_[index].users > 0);
    --entries_[index].users;
}

std::size_t Spaces::size() const {
    const auto in_use = [](const Entry& entry) { return entry.users > 0; };
    return static_cast<std::size_t>(std::ranges::count_if(entries_, in_use));
}

}  // namespace hyrax
