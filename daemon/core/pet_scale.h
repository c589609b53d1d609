// SPDX-License-Identifier: MIT
// The size of single pets, for engines that have such: where Engine has no set_scale(), menus show
// no sizes and the wheel does nothing.
#pragma once

#include "daemon/core/log_failure.h"
#include "daemon/core/pet.h"

#include <optional>

namespace hyrax {

template <typename E, typename P = Pet>
concept Scalable = requires(E& engine, const P& pet, PetId id) {
    engine.set_scale(id, 1.0);
    pet.scale;
};

template <typename E, typename P>
std::optional<double> scale_of(const E&, const P& pet) {
    if constexpr (Scalable<E, P>) {
        return pet.scale;
    }
    return std::nullopt;
}

template <typename E>
void scale_pet(E& engine, PetId id, double scale) {
    if constexpr (Scalable<E>) {
        log_failure(engine.set_scale(id, scale));
    }
}

}  // namespace hyrax
