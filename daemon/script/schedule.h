// SPDX-License-Identifier: MIT
// What a script waits for: handlers of events, timers, coroutines that wait. Knows no Lua:
// functions and coroutines are numbers and pointers that the owner understands.
#pragma once

#include "daemon/core/event.h"
#include "daemon/core/script_port.h"
#include "physics/ticks.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

struct lua_State;

namespace hyrax::script {

/// What handlers can listen to: the engine's events, then those of the host.
enum class Topic : std::uint8_t {
    spawn,
    remove,
    grab,
    throw_pet,
    bounce,
    land,
    click,
    collide,
    monitors,
    ready,
    tick,
    config,
    unload,
    hotkey  ///< Heard through hyrax.hotkey alone.
};

/// As scripts spell them, in the order of Topic.
inline constexpr std::array<std::string_view, 13> topic_names{
    "spawn",
    "remove",
    "grab",
    "throw",
    "bounce",
    "land",
    "click",
    "collide",
    "monitors",
    "ready",
    "tick",
    "config",
    "unload"
};

constexpr Topic topic_of(EventKind kind) {
    return static_cast<Topic>(kind);
}

constexpr bool is_about_pets(Topic topic) {
    return topic < Topic::monitors;
}

/// A coroutine made by the host, and the registry reference that keeps it alive.
struct HostThread {
    lua_State* lua = nullptr;
    int anchor = 0;
};

struct Handler {
    std::uint64_t id = 0;
    Topic topic = Topic::ready;
    PetKey pet = 0;  ///< 0: any.
    int function = 0;
    /// True if an event of this topic that is about these two pets, or none, is meant for it.
    bool hears(Topic what, PetKey first, PetKey second) const {
        return topic == what && (pet == 0 || pet == first || pet == second);
    }
};

struct Timer {
    std::uint64_t id = 0;
    Ticks due = 0;
    Ticks period = 0;  ///< 0: fires once.
    int function = 0;
};

struct Waiter {
    std::uint64_t id = 0;
    Ticks since = 0;
    Ticks due = never;
    PetKey pet = 0;  ///< 0: waits for time alone.
    Topic topic = Topic::ready;
    HostThread thread = {};
};

/// Ids are never reused; what has the smaller id was there first.
class Schedule {
public:
    std::uint64_t add(Handler handler, Ticks now);
    std::uint64_t add(Timer timer);
    void add(Waiter waiter);

    const std::vector<Handler>& handlers() const { return handlers_; }
    const std::vector<Timer>& timers() const { return timers_; }
    const std::vector<Waiter>& waiters() const { return waiters_; }
    const Handler* handler(std::uint64_t id) const;

    /// The function of the handler or timer that was cancelled, if it was still there.
    std::optional<int> cancel(std::uint64_t id);
    /// Ends all handlers of a topic; their functions stay kept.
    void drop(Topic topic);
    std::optional<Waiter> take_waiter(std::uint64_t id);
    bool is_waiting(const lua_State* thread) const;

    /// The earliest timer that is due, moved to its next time or taken out.
    std::optional<Timer> take_timer(Ticks now);
    /// The earliest waiter that is due and, with `before`, due earlier than that timer.
    std::optional<Waiter> take_due_waiter(Ticks now, Ticks before);
    Ticks next_timer() const;
    /// True once a tick is due; `seconds` is then the time since the last one.
    std::optional<double> take_tick(Ticks now);

    EventMask listening() const;
    Ticks next_wake() const;

private:
    bool has_tick_handler() const;

    std::vector<Handler> handlers_;
    std::vector<Timer> timers_;
    std::vector<Waiter> waiters_;
    std::uint64_t last_id_ = 0;
    Ticks tick_due_ = 0;
    Ticks last_tick_ = 0;
};

/// The shortest time between two ticks.
inline constexpr Ticks tick_period = ticks_per_second / 60;
/// The shortest period of a timer, and the shortest wait.
inline constexpr Ticks shortest_period = ticks_per_second / 120;

}  // namespace hyrax::script
