// SPDX-License-Identifier: MIT
#include "daemon/script/schedule.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace hyrax::script {
namespace {

// Frames are not exact; a tick that is this early is better than one that is a frame late.
constexpr Ticks early_tick = ticks_per_ms;
// Whoever is later than this had a pause, after which what was missed is not made up for.
constexpr Ticks longest_lag = ticks_per_second / 10;

template <typename Item>
std::optional<Item> take(std::vector<Item>& items, typename std::vector<Item>::iterator found) {
    if (found == items.end()) {
        return std::nullopt;
    }
    Item item = *found;
    items.erase(found);
    return item;
}

template <typename Item>
auto earliest(std::vector<Item>& items) {
    return std::ranges::min_element(items, {}, [](const Item& item) {
        return std::tuple(item.due, item.id);
    });
}

}  // namespace

std::uint64_t Schedule::add(Handler handler, Ticks now) {
    if (handler.topic == Topic::tick && !has_tick_handler()) {
        last_tick_ = now;
        tick_due_ = now + tick_period;
    }
    handler.id = ++last_id_;
    handlers_.push_back(handler);
    return handler.id;
}

std::uint64_t Schedule::add(Timer timer) {
    timer.id = ++last_id_;
    timers_.push_back(timer);
    return timer.id;
}

void Schedule::add(Waiter waiter) {
    waiter.id = ++last_id_;
    waiters_.push_back(waiter);
}

const Handler* Schedule::handler(std::uint64_t id) const {
    const auto found = std::ranges::find(handlers_, id, &Handler::id);
    return found == handlers_.end() ? nullptr : &*found;
}

std::optional<int> Schedule::cancel(std::uint64_t id) {
    if (const auto handler = take(handlers_, std::ranges::find(handlers_, id, &Handler::id))) {
        return handler->function;
    }
    if (const auto timer = take(timers_, std::ranges::find(timers_, id, &Timer::id))) {
        return timer->function;
    }
    return std::nullopt;
}

void Schedule::drop(Topic topic) {
    std::erase_if(handlers_, [topic](const Handler& handler) { return handler.topic == topic; });
}

std::optional<Waiter> Schedule::take_waiter(std::uint64_t id) {
    return take(waiters_, std::ranges::find(waiters_, id, &Waiter::id));
}

bool Schedule::is_waiting(const lua_State* thread) const {
    return std::ranges::any_of(waiters_, [thread](const Waiter& waiter) {
        return waiter.thread.lua == thread;
    });
}

std::optional<Timer> Schedule::take_timer(Ticks now) {
    const auto found = earliest(timers_);
    if (found == timers_.end() || found->due > now) {
        return std::nullopt;
    }
    const Timer timer = *found;
    if (timer.period == 0) {
        timers_.erase(found);
    } else {
        const bool had_pause = now - timer.due > longest_lag;
        found->due = (had_pause ? now : timer.due) + timer.period;
    }
    return timer;
}

std::optional<Waiter> Schedule::take_due_waiter(Ticks now, Ticks before) {
    const auto found = earliest(waiters_);
    if (found == waiters_.end() || found->due > now || found->due >= before) {
        return std::nullopt;
    }
    return take(waiters_, found);
}

Ticks Schedule::next_timer() const {
    Ticks next = never;
    for (const Timer& timer : timers_) {
        next = std::min(next, timer.due);
    }
    return next;
}

std::optional<double> Schedule::take_tick(Ticks now) {
    if (!has_tick_handler() || now + early_tick < tick_due_) {
        return std::nullopt;
    }
    tick_due_ += tick_period;
    if (tick_due_ <= now) {
        tick_due_ = now + tick_period;
    }
    return to_seconds(now - std::exchange(last_tick_, now));
}

bool Schedule::has_tick_handler() const {
    return std::ranges::any_of(handlers_, [](const Handler& handler) {
        return handler.topic == Topic::tick;
    });
}

EventMask Schedule::listening() const {
    EventMask mask;
    const auto listen = [&mask](Topic topic) {
        if (topic < Topic::ready) {
            mask.add(static_cast<EventKind>(topic));
        }
    };
    for (const Handler& handler : handlers_) {
        listen(handler.topic);
    }
    for (const Waiter& waiter : waiters_) {
        if (waiter.pet != 0) {
            listen(waiter.topic);
            listen(Topic::remove);  // which ends every wait for a pet
        }
    }
    return mask;
}

Ticks Schedule::next_wake() const {
    Ticks next = next_timer();
    for (const Waiter& waiter : waiters_) {
        next = std::min(next, waiter.due);
    }
    return has_tick_handler() ? std::min(next, tick_due_) : next;
}

}  // namespace hyrax::script
