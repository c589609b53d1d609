// SPDX-License-Identifier: MIT
// Pets and the tops of windows: who stands on one goes where it goes, who flies heeds those that it
// will meet.
#include "daemon/core/engine.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace hyrax {
namespace {

// A window that rises or sinks by this in one update leaves its pets behind [px].
constexpr int yanked = 200;

// How long before a pet comes down on a window it matters that the window moves.
constexpr Ticks soon = ticks_per_second / 2;

bool same_contact(const Contact& a, const Contact& b) {
    return a.time == b.time && a.kind == b.kind && a.side == b.side;
}

// How far the window of a segment has gone, if it is still there and was not yanked away. One that
// is resized moves nobody sideways.
std::optional<Vec2> way_of(const LedgeSegment& former, const std::vector<LedgeSegment>& ledges) {
    const auto now = std::ranges::find(ledges, former.window, &LedgeSegment::window);
    if (now == ledges.end() || std::abs(now->bounds.y - former.bounds.y) >= yanked) {
        return std::nullopt;
    }
    const bool resized = now->bounds.width != former.bounds.width;
    return Vec2{
        resized ? 0.0 : static_cast<double>(now->bounds.x - former.bounds.x),
        static_cast<double>(now->bounds.y - former.bounds.y)
    };
}

}  // namespace

struct Engine::Footing {
    PetId pet;
    bool folded = false;
    Contact next;               // What it would meet next, as far as this is known beforehand.
    std::optional<Vec2> carry;  // Where the window under it has gone.
};

bool Engine::knows_ledges() const {
    return rules_.integrator != Integrator::semi_implicit_euler;
}

// Where the pet is, for the space of its size.
BodyState Engine::state_in_space(const Pet& pet) const {
    BodyState state = pet.shown;
    state.position = state.position + around(pet).space.overhang();
    state.mode = pet.body.mode();
    return state;
}

Contact Engine::next_contact_of(const Pet& pet) const {
    // Other integrators look where they are in each step.
    if (rules_.integrator != Integrator::event_driven) {
        return {};
    }
    return next_contact(state_in_space(pet), rules_.law, around(pet).space);
}

/// Whose top is exactly at that place of its space, unless a floor is.
const LedgeSegment* Engine::ledge_at(const Pet& pet, Vec2 at) const {
    const FreeSpace& space = around(pet).space;
    const auto carries = [at](const Barrier& floor) {
        return floor.at == at.y && at.x > floor.low && at.x < floor.high;
    };
    const std::span<const Barrier> tops = space.ledges();
    if (std::ranges::any_of(space.floors().first(space.floors().size() - tops.size()), carries)) {
        return nullptr;
    }
    const auto found = std::ranges::find_if(tops, carries);
    return found == tops.end() ? nullptr : &ledges_[static_cast<std::size_t>(found - tops.begin())];
}

const LedgeSegment* Engine::ledge_under(const Pet& pet) const {
    if (ledges_.empty() || pet.motion == Motion::held || pet.body.mode() == Mode::air) {
        return nullptr;
    }
    return ledge_at(pet, state_in_space(pet).position);
}

const LedgeSegment* Engine::ledge_ahead(const Pet& pet) const {
    if (ledges_.empty() || !pet.started || pet.frozen() || pet.motion == Motion::held ||
        pet.body.mode() != Mode::air || pet.body.next_event() > own_time(pet) + soon) {
        return nullptr;
    }
    const Contact next = next_contact_of(pet);
    if (next.kind != ContactKind::floor) {
        return nullptr;
    }
    const Vec2 there = free_motion(state_in_space(pet), rules_.law, next.time).position;
    return ledge_at(pet, {there.x, next.side});
}

std::vector<std::uint64_t> Engine::windows_underfoot() const {
    std::vector<std::uint64_t> windows;
    if (!knows_ledges()) {
        return windows;
    }
    pets_.for_each([&](PetId, const Pet& pet) {
        for (const LedgeSegment* const ledge : {ledge_under(pet), ledge_ahead(pet)}) {
            if (ledge != nullptr) {
                windows.push_back(ledge->window);
            }
        }
    });
    std::ranges::sort(windows);
    windows.erase(std::ranges::unique(windows).begin(), windows.end());
    return windows;
}

void Engine::set_ledges(std::vector<LedgeSegment> ledges) {
    if (ledges == ledges_) {
        return;
    }
    std::vector<Footing> footings;
    if (knows_ledges() && !arena_.empty()) {
        pets_.for_each([&](PetId id, const Pet& pet) {
            if (pet.motion == Motion::held) {
                return;
            }
            const LedgeSegment* const under = ledge_under(pet);
            footings.push_back({
                .pet = id,
                .folded = pet.body.is_folded(),
                .next = next_contact_of(pet),
                .carry = under != nullptr ? way_of(*under, ledges) : std::nullopt,
            });
        });
    }
    ledges_ = std::move(ledges);
    lay_ledges();
    spaces_.set_arena(arena_);
    for (const Footing& footing : footings) {
        find_footing(footing, *pets_.find(footing.pet));
    }
}

void Engine::lay_ledges() {
    std::vector<Ledge> plain;
    for (const LedgeSegment& segment : ledges_) {
        plain.push_back(segment.ledge);
    }
    arena_.set_ledges(std::move(plain));
}

// Whoever meets the same things as before goes on as before, to the bit.
void Engine::find_footing(const Footing& before, Pet& pet) {
    const Mode mode = pet.body.mode();
    const bool carried = before.carry && *before.carry != Vec2{};
    if (carried) {
        place(pet, pet.position() + *before.carry);
    }
    const bool stood = mode != Mode::air && rules_.law.gravity > 0.0;
    const bool fell = stood && !around(pet).space.support(state_in_space(pet).position);
    const bool turned = mode != Mode::rest && !same_contact(before.next, next_contact_of(pet));
    if (!carried && !fell && !turned && !before.folded && !walk_is_outdated(pet)) {
        return;
    }
    // Who moves goes on moving from the last frame on; who rested begins with the next one.
    const bool under_way = pet.awake && pet.started;
    set_in_motion(before.pet, pet, pet.velocity());
    if (under_way && !pet.frozen()) {
        pet.body.start(own_time(pet));
        pet.started = true;
        if (pet.walk && pet.body.mode() != Mode::air) {
            begin_walk(pet, own_time(pet), pet.position());
        }
    }
}

}  // namespace hyrax
