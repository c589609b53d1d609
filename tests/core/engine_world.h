// SPDX-License-Identifier: MIT
// An engine with one monitor, a clock, and every event remembered.
#pragma once

#include "daemon/core/engine.h"

#include <doctest/doctest.h>

namespace hyrax {

constexpr Ticks frame = ticks_per_second / 60;
constexpr Size box{100, 80};

inline Monitor monitor(Rect bounds) {
    return {.bounds = bounds, .work = bounds, .primary = true, .name = {}};
}

struct World {
    explicit World(EngineSettings settings = {})
        : engine({{"hyrax", box}, {"other", {50, 50}}}, settings, 1) {
        engine.listen(EventMask::all());
        engine.set_arena(Arena({monitor({0, 0, 1920, 1080})}, FloorEdge::work_area));
        engine.take_events();
    }

    PetId spawn(Vec2 at, Vec2 velocity = {}) {
        const Result<PetId> id = engine.spawn({.at = at, .velocity = velocity});
        REQUIRE(id.has_value());
        return *id;
    }
    void run(double seconds) {
        for (const Ticks end = now + from_seconds(seconds); now < end; now += frame) {
            engine.advance(now);
        }
    }
    int count(EventKind kind) {
        int found = 0;
        for (const Event& event : engine.take_events()) {
            found += event.kind == kind ? 1 : 0;
        }
        return found;
    }
    const Pet& pet(PetId id) const { return *engine.find(id); }

    Engine engine;
    Ticks now = 0;
};

inline bool same(const Pet& a, const Pet& b) {
    return a.position() == b.position() && a.velocity() == b.velocity() && a.motion == b.motion &&
           a.awake == b.awake;
}

}  // namespace hyrax
