// SPDX-License-Identifier: MIT
// What happened to pets, as plain data for whoever listens.
#pragma once

#include "daemon/core/pet.h"

#include <cstdint>
#include <string>

namespace hyrax {

enum class EventKind : std::uint8_t {
    spawn,
    remove,
    grab,
    throw_pet,
    bounce,
    land,
    click,
    collide,
    monitors
};

inline constexpr EventKind last_event_kind = EventKind::monitors;

enum class Side : std::uint8_t { left, right, top, bottom };

enum class Button : std::uint8_t { left, right, middle };

/// Fields that a kind does not name keep their defaults.
struct Event {
    EventKind kind = EventKind::spawn;
    PetId pet{};
    Side side = Side::bottom;      ///< bounce
    Button button = Button::left;  ///< click
    /// bounce, land: towards the side at the impact; collide: of one pet towards the other [px/s].
    double speed = 0.0;
    Vec2 velocity{};    ///< throw_pet [px/s]
    std::string tag{};  ///< remove: the tag of the pet that is no more.
    PetId other{};      ///< collide: whom it met.

    bool operator==(const Event&) const = default;
};

/// The kinds of events that somebody listens to; no other event is built.
class EventMask {
public:
    constexpr EventMask() = default;
    static constexpr EventMask all() {
        EventMask mask;
        mask.bits_ = ~0U;
        return mask;
    }
    constexpr void add(EventKind kind) { bits_ |= bit(kind); }
    constexpr void add(EventMask other) { bits_ |= other.bits_; }
    constexpr bool has(EventKind kind) const { return (bits_ & bit(kind)) != 0; }
    /// As a number, for wires.
    constexpr std::uint32_t bits() const { return bits_; }
    static constexpr EventMask from_bits(std::uint32_t bits) {
        EventMask mask;
        mask.bits_ = bits;
        return mask;
    }
    bool operator==(const EventMask&) const = default;

private:
    static constexpr std::uint32_t bit(EventKind kind) {
        return 1U << static_cast<std::uint32_t>(kind);
    }
    std::uint32_t bits_ = 0;
};

}  // namespace hyrax
