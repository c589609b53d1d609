// SPDX-License-Identifier: MIT
#include "daemon/core/trace.h"

#include <fmt/format.h>

#include <utility>

namespace hyrax {
namespace {

const char* motion_name(Motion motion) {
    switch (motion) {
        case Motion::airborne:
            return "airborne";
        case Motion::settled:
            return "settled";
        case Motion::held:
            return "held";
        case Motion::walking:
            return "walking";
    }
    std::unreachable();
}

}  // namespace

Result<Trace> Trace::open(const std::filesystem::path& path) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    if (!file) {
        return failure(fmt::format("{}: cannot be written", path.string()));
    }
    file << "time,pet,generation,kind,x,y,vx,vy,motion\n";
    return Trace(std::move(file));
}

void Trace::write(const Engine& engine, Ticks now) {
    if (first_ == never) {
        first_ = now;
    }
    const double time = to_seconds(now - first_);
    engine.for_each([&](PetId id, const Pet& pet) {
        const Vec2 at = pet.position();
        const Vec2 v = pet.velocity();
        file_ << fmt::format(
            "{:.9f},{},{},{},{:.17g},{:.17g},{:.17g},{:.17g},{}\n",
            time,
            id.index,
            id.generation,
            engine.kinds()[pet.kind].name,
            at.x,
            at.y,
            v.x,
            v.y,
            motion_name(pet.motion)
        );
    });
    // Whoever follows the file sees whole frames.
    file_.flush();
}

}  // namespace hyrax
