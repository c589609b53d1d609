// SPDX-License-Identifier: MIT
#include "daemon/core/daemon.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

namespace hyrax {

Daemon::Daemon(Desktop& desktop, DaemonOptions options)
    : desktop_(desktop),
      profile_(std::move(options.profile)),
      decode_(std::move(options.decode)),
      fps_(options.fps),
      sets_{placeholder_sprite_set("hyrax")},
      engine_(kinds_of(sets_), config_.engine, options.seed),
      scripts_(std::move(options.scripts)),
      speeches_(std::move(options.paint_text)),
      stores_(profile_.state.empty() ? profile_.state : profile_.state / "store"),
      trace_(std::move(options.trace)),
      first_requests_(std::move(options.requests)),
      welcomed_(!options.welcome) {
    read_config();
    read_kinds();
    use_monitors();
    read_scripts();
}

void Daemon::run() {
    while (!quitting_) {
        run_due();
        for (const Input& input : desktop_.wait(next_frame_)) {
            handle(input);
        }
    }
    scripts_.end(engine_, monitors_, clock_.at(desktop_.now()));
    grant_wishes(desktop_.now());
    stores_.write_all();
}

void Daemon::run_due() {
    if (changed_) {
        next_frame_ = std::min(next_frame_, pacer_.next());
    }
    const Ticks now = desktop_.now();
    if (now >= next_frame_) {
        draw(now);
    }
}

void Daemon::draw(Ticks now) {
    const Ticks world = clock_.at(now);
    changed_ = false;
    welcome();
    const bool swinging = engine_.advance_held(now);
    if (!clock_.paused()) {
        engine_.advance(world);
        scripts_.run(engine_, monitors_, world);
        changed_ = engine_.has_events();
        grant_wishes(now);
    }
    stores_.write_due(now);
    Staged next = staged(engine_, sets_, world, from_seconds(config_.drowsy_after));
    if (speeches_.concern(next.speakers)) {
        speeches_.show(next.frame, engine_, next.speakers);
    }
    if (next.frame != frame_) {
        frame_ = std::move(next.frame);
        desktop_.present(frame_);
    }
    if (trace_) {
        trace_->write(engine_, world);
    }
    report();
    pacer_.drawn(now);
    const Ticks wake = std::min(
        clock_.machine_time(std::min(next.next_change, scripts_.next_wake())), stores_.next_write()
    );
    const bool every_frame = swinging || (engine_.moving() && !clock_.paused());
    next_frame_ = every_frame ? pacer_.next() : std::max(wake, pacer_.next());
}

// What scripts ask of somebody else than the engine.
void Daemon::grant_wishes(Ticks now) {
    for (ScriptCommand& wish : scripts_.take_wishes()) {
        if (auto* const store = std::get_if<command::Store>(&wish)) {
            stores_.set(store->script, store->key, std::move(store->value), now);
        } else if (const auto* const notice = std::get_if<command::Notify>(&wish)) {
            spdlog::info("notice of {}: {}", notice->script, notice->text);
        }
    }
}

void Daemon::welcome() {
    if (welcomed_ || engine_.arena().empty()) {
        return;
    }
    welcomed_ = true;
    for (const StartPets& pets : config_.start_pets) {
        for (int i = 0; i < pets.count; ++i) {
            const SpawnOptions options{.kind = pets.kind, .at = pets.at, .velocity = pets.velocity};
            if (const Result<PetId> id = engine_.spawn(options); !id) {
                spdlog::warn("config.json: /pets/start: {}", id.error().message);
                break;
            }
        }
    }
    for (const Request& request : std::exchange(first_requests_, {})) {
        on(request);
    }
}

void Daemon::report() {
    std::string problem = config_problem_;
    const std::vector<std::string>* const lists[] = {
        &kind_problems_, &script_problems_, &scripts_.problems()
    };
    for (const std::vector<std::string>* list : lists) {
        if (problem.empty() && !list->empty()) {
            problem = list->front();
        }
    }
    const Status status{engine_.size(), clock_.paused(), std::move(problem)};
    if (status != shown_status_) {
        shown_status_ = status;
        desktop_.show_status(status);
    }
}

}  // namespace hyrax
