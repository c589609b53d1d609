// SPDX-License-Identifier: MIT
#include "daemon/core/daemon.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
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
      control_(std::move(options.control)),
      speeches_(std::move(options.paint_text)),
      stores_(
          profile_.state.empty() ? std::filesystem::path() : profile_.state.parent_path() / "store"
      ),
      trace_(std::move(options.trace)),
      first_requests_(std::move(options.requests)),
      begin_(desktop.now()),
      welcomed_(!options.welcome) {
    recall();
    read_config();
    read_plugins();
    read_kinds();
    use_monitors();
    load_wanted_scripts();
    choose_conduct(false, false);  // The first window must appear where it belongs.
}

void Daemon::run() {
    while (!quitting_) {
        run_due();
        for (const Input& input : desktop_.wait(next_frame_)) {
            handle(input);
        }
    }
    end();
}

// What scripts keep as they hear of the end is written, if they say it in time.
void Daemon::end() {
    if (std::exchange(ended_, true)) {
        return;
    }
    quitting_ = true;
    constexpr std::chrono::milliseconds patience{300};
    const Ticks now = desktop_.now();
    scripts_.end(engine_, monitors_, {.world = clock_.at(now), .machine = now}, patience);
    grant_wishes(now);
    hotkeys_.give_back_all(desktop_);
    stores_.write_all();
}

void Daemon::run_due() {
    if (ended_) {
        return;
    }
    if (changed_) {
        next_frame_ = std::min(next_frame_, pacer_.next());
    }
    const Ticks now = desktop_.now();
    if (now >= next_frame_) {
        draw(now);
    }
}

void Daemon::draw(Ticks now) {
    changed_ = false;
    if (remembered_.hidden) {
        show_when_due(now);
    }
    heed_presence(now);
    scripts_.watch(now);
    control_.tell_late(*this, desktop_, now);
    const Decisions& so = presence_.decisions();
    if (so.unseen) {
        report();
        choose_conduct(false, false);
        stores_.write_due(now);
        next_frame_ = std::min({scripts_.watch_due(), stores_.next_write(), control_.due()});
        return;
    }
    const Ticks world = clock_.at(now);
    welcome();
    const bool swinging = engine_.advance_held(now);
    mind_windows();
    if (!clock_.paused()) {
        engine_.advance(world);
        scripts_.run(engine_, monitors_, world, script_eyes());
        changed_ = engine_.has_events();
        grant_wishes(now);
        control_.tell_evaluated(*this, desktop_, scripts_.take_evaluated());
        turn_off_given_up();
    }
    mind_windows();
    stores_.write_due(now);
    control_.tell_watchers(engine_, desktop_, to_seconds(world - begin_));
    Staged next;
    if (!so.windowless && !remembered_.hidden) {
        next = staged(
            engine_,
            sets_,
            atlas_,
            {.now = world,
             .drowsy_after = from_seconds(config_.drowsy_after),
             .opacity = config_.opacity,
             .calm = so.calm}
        );
        next.frame.kept_free = so.kept_free;
        next.frame.edition = edition_;
    }
    if (speeches_.concern(next.speakers)) {
        speeches_.show(next.frame, engine_, next.speakers);
    }
    const bool lost = std::exchange(frame_lost_, false);
    if (next.frame != frame_ || lost) {
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
    const Ticks due =
        std::min({wake, presence_.due(), scripts_.watch_due(), show_at_, control_.due()});
    next_frame_ = every_frame ? pacer_.next() : std::max(due, pacer_.next());
    // To lie down some time later is no animation.
    const bool animated = !clock_.paused() && next.next_change - world < 2 * ticks_per_second;
    choose_conduct(every_frame, animated);
    ++frames_;
    if (control_.is_open()) {
        drawing_ += desktop_.now() - now;
    }
}

// What scripts ask of somebody else than the engine.
void Daemon::grant_wishes(Ticks now) {
    if (scripts_.take_loss()) {
        hotkeys_.give_back_scripts(desktop_);
    }
    for (ScriptCommand& wish : scripts_.take_wishes()) {
        if (auto* const store = std::get_if<command::Store>(&wish)) {
            stores_.set(store->script, store->key, std::move(store->value), now);
        } else if (const auto* const notice = std::get_if<command::Notify>(&wish)) {
            grant(*notice, now);
        } else if (const auto* const hotkey = std::get_if<command::Hotkey>(&wish)) {
            grant(*hotkey, now);
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
    if (quiet()) {
        settle();
    }
    greet();
}

std::string Daemon::problem() const {
    if (!config_problem_.empty()) {
        return config_problem_;
    }
    for (const std::vector<std::string>* list :
         {&kind_problems_, &script_problems_, &plugin_problems_}) {
        if (!list->empty()) {
            return list->front();
        }
    }
    if (!scripts_.errors().empty()) {
        return scripts_.errors().begin()->second;
    }
    if (place_problem_.empty() && config_.presence.hide_from_capture &&
        presence_.facts().capture_refused) {
        return "captures show the pets: the system refused overlay.hide_from_capture";
    }
    return place_problem_;
}

Status Daemon::status() const {
    return {
        .pets = engine_.size(),
        .paused = paused_,
        .hidden = remembered_.hidden,
        .quiet = quiet(),
        .click_through = click_through(),
        .problem = problem(),
        .note = presence_.decisions().note.empty() ? plugins_ask_ : presence_.decisions().note,
    };
}

Figures Daemon::figures() const {
    const Ticks world = clock_.at(desktop_.now());
    const auto frames = static_cast<double>(std::max<std::uint64_t>(1, frames_));
    return {
        .seconds = to_seconds(world - begin_),
        .frames = frames_,
        .frame_ns = static_cast<double>(drawing_) / frames,
    };
}

void Daemon::report() {
    Status now = status();
    if (now != shown_status_) {
        shown_status_ = std::move(now);
        desktop_.show_status(shown_status_);
    }
}

}  // namespace hyrax
