// SPDX-License-Identifier: MIT
// Where boxes may be in the present arena: one free space for each size in use.
#pragma once

#include "daemon/core/arena.h"
#include "physics/free_space.h"
#include "physics/geometry.h"

#include <cstddef>
#include <vector>

namespace hyrax {

class Spaces {
public:
    /// Measures every space in use anew; their indices stay.
    void set_arena(const Arena& arena);

    /// The index of the space for this size (positive); it stays until as many calls of release().
    [[nodiscard]] std::size_t acquire(Size box);
    void release(std::size_t index);

    const FreeSpace& operator[](std::size_t index) const { return entries_[index].space; }
    Size box(std::size_t index) const { return entries_[index].box; }
    /// How many sizes are in use.
    std::size_t size() const;

private:
    struct Entry {
        Size box;
        std::size_t users = 0;
        FreeSpace space;
    };

    Arena arena_;
    std::vector<Entry> entries_;  // Those without users are kept for the next pet of their size.
};

}  // namespace hyrax
