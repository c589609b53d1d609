// SPDX-License-Identifier: MIT
#include "daemon/core/control_desk.h"

#include "daemon/core/daemon.h"

#include <fmt/format.h>

#include <algorithm>

namespace hyrax {

void ControlDesk::answer(Daemon& daemon, Desktop& desktop, const input::Asked& asked) {
    if (!port_) {
        return;
    }
    const ControlAnswer given = port_->answer(daemon, asked.text, watchers_.size());
    if (given.evaluation) {
        waiting_.push_back({asked.client, *given.evaluation, desktop.now() + patience});
        return;
    }
    if (given.watch) {
        watchers_.push_back({asked.client, *given.watch});
        watch(daemon.engine());
    }
    desktop.answer(asked.client, given.text, given.watch ? Answer::more : Answer::last);
}

void ControlDesk::forget(Engine& engine, ClientId client) {
    if (std::erase_if(watchers_, [client](const Watcher& w) { return w.client == client; }) > 0) {
        watch(engine);
    }
}

void ControlDesk::tell_evaluated(
    Daemon& daemon, Desktop& desktop, const std::vector<Evaluated>& evaluated
) {
    for (const Evaluated& each : evaluated) {
        const auto found = std::ranges::find(waiting_, each.id, &Waiting::evaluation);
        if (found != waiting_.end()) {
            const ClientId client = found->client;
            waiting_.erase(found);
            desktop.answer(client, port_->evaluated(daemon, each), Answer::last);
        }
    }
}

void ControlDesk::tell_late(Daemon& daemon, Desktop& desktop, Ticks now) {
    if (waiting_.empty()) {
        return;
    }
    std::vector<Evaluated> late;
    for (const Waiting& waiting : waiting_) {
        if (now >= waiting.until) {
            late.push_back({
                .id = waiting.evaluation,
                .good = false,
                .text = fmt::format(
                    "no answer within {} s; the script goes on", patience / ticks_per_second
                ),
            });
        }
    }
    tell_evaluated(daemon, desktop, late);
}

Ticks ControlDesk::due() const {
    Ticks earliest = never;
    for (const Waiting& waiting : waiting_) {
        earliest = std::min(earliest, waiting.until);
    }
    return earliest;
}

void ControlDesk::tell_watchers(Engine& engine, Desktop& desktop, double seconds) {
    if (watchers_.empty()) {
        return;
    }
    for (const Event& event : engine.take_watched()) {
        const std::string text = port_->told(engine, event, seconds);
        for (const Watcher& watcher : watchers_) {
            if (watcher.mask.has(event.kind)) {
                desktop.answer(watcher.client, text, Answer::more);
            }
        }
    }
}

void ControlDesk::watch(Engine& engine) const {
    EventMask wanted;
    for (const Watcher& watcher : watchers_) {
        wanted.add(watcher.mask);
    }
    engine.watch(wanted);
    if (watchers_.empty()) {
        engine.take_watched();
    }
}

}  // namespace hyrax
