// SPDX-License-Identifier: MIT
#include "daemon/core/daemon.h"

#include "daemon/core/config_advice.h"
#include "daemon/core/files.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

namespace hyrax {
namespace {

std::vector<Kind> kinds_of(const std::vector<SpriteSet>& sets) {
    std::vector<Kind> kinds;
    for (const SpriteSet& set : sets) {
        kinds.push_back({set.name, {set.box.width, set.box.height}});
    }
    return kinds;
}

void log_failure(const Result<void>& done) {
    if (!done) {
        spdlog::warn("{}", done.error().message);
    }
}

}  // namespace

Daemon::Daemon(Desktop& desktop, DaemonOptions options)
    : desktop_(desktop),
      profile_(std::move(options.profile)),
      decode_(std::move(options.decode)),
      fps_(options.fps),
      sets_{placeholder_sprite_set("hyrax")},
      engine_(kinds_of(sets_), config_.engine, options.seed),
      scripts_(std::move(options.scripts)),
      trace_(std::move(options.trace)),
      first_requests_(std::move(options.requests)) {
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
    }
    Staged next = staged(engine_, sets_, world, from_seconds(config_.drowsy_after));
    if (next.frame != frame_) {
        frame_ = std::move(next.frame);
        desktop_.present(frame_);
    }
    if (trace_) {
        trace_->write(engine_, world);
    }
    report();
    pacer_.drawn(now);
    const Ticks wake = clock_.machine_time(std::min(next.next_change, scripts_.next_wake()));
    const bool every_frame = swinging || (engine_.moving() && !clock_.paused());
    next_frame_ = every_frame ? pacer_.next() : std::max(wake, pacer_.next());
}

void Daemon::handle(const Input& input) {
    std::visit([this](const auto& which) { on(which); }, input);
    changed_ = true;
}

void Daemon::on(const input::Pressed& pressed) {
    const std::optional<PetId> id = pet_at(frame_, pressed.at);
    const Pet* pet = id ? engine_.find(*id) : nullptr;
    if (pet == nullptr) {
        return;
    }
    if (pressed.button != Button::left) {
        engine_.click(*id, pressed.button);
        return;
    }
    let_go(desktop_.now(), 0.0);
    const Vec2 pointer{static_cast<double>(pressed.at.x), static_cast<double>(pressed.at.y)};
    hand_.take(*id, pet->position() - pointer, pressed.at, pressed.time);
    log_failure(engine_.grab(*id, pressed.time));
}

void Daemon::on(const input::Moved& moved) {
    const std::optional<PetId> held = hand_.pet();
    if (!held) {
        return;
    }
    hand_.move(moved.at);
    // A script may have removed the pet out of the hand.
    if (!engine_.carry(*held, hand_.carried_to(), moved.time)) {
        hand_.drop();
    }
}

void Daemon::on(const input::Released& released) {
    const std::optional<PetId> held = hand_.pet();
    if (!held || released.button != Button::left) {
        return;
    }
    on(input::Moved{released.at, released.time});
    const bool clicked = hand_.was_click(released.time);
    let_go(released.time, clicked ? 0.0 : config_.max_throw_speed);
    if (clicked) {
        engine_.click(*held, Button::left);
    }
}

void Daemon::on(const input::PointerLost&) {
    let_go(desktop_.now(), 0.0);
}

void Daemon::on(const input::MonitorsChanged&) {
    let_go(desktop_.now(), 0.0);
    use_monitors();
}

void Daemon::on(const input::FilesChanged&) {
    read_config();
    read_scripts();
}

void Daemon::on(const Request& request) {
    std::visit([this](const auto& which) { carry_out(which); }, request);
}

void Daemon::carry_out(const request::Spawn& spawn) {
    for (int i = 0; i < spawn.count; ++i) {
        if (const Result<PetId> id = engine_.spawn({.kind = spawn.kind}); !id) {
            spdlog::warn("{}", id.error().message);
            return;
        }
    }
}

void Daemon::carry_out(const request::FlingAll&) {
    engine_.fling_all();
}

void Daemon::carry_out(const request::ResetAll&) {
    engine_.reset_all();
}

void Daemon::carry_out(const request::RemoveAll&) {
    hand_.drop();
    engine_.clear();
}

void Daemon::carry_out(const request::SetPaused& pause) {
    clock_.set_paused(pause.paused, desktop_.now());
}

void Daemon::carry_out(const request::TogglePause&) {
    clock_.set_paused(!clock_.paused(), desktop_.now());
}

void Daemon::carry_out(const request::Reload&) {
    read_config();
    read_kinds();
    sources_.clear();
    read_scripts();
}

void Daemon::carry_out(const request::Quit&) {
    quitting_ = true;
}

void Daemon::let_go(Ticks time, double max_speed) {
    if (const std::optional<PetId> held = hand_.pet()) {
        hand_.drop();
        if (engine_.find(*held) != nullptr) {
            log_failure(engine_.let_go(*held, time, max_speed));
        }
    }
}

void Daemon::read_config() {
    const Result<LoadedConfig> loaded = load_config(profile_.config);
    if (!loaded) {
        // The same broken text is told once, however often the file is touched.
        if (loaded.error().message != config_problem_) {
            spdlog::error("{}", loaded.error().message);
            spdlog::error("the settings stay as they were");
        }
        config_problem_ = loaded.error().message;
        return;
    }
    config_problem_.clear();
    if (last_read_ == loaded->config) {
        return;
    }
    last_read_ = loaded->config;
    for (const std::string& warning : loaded->warnings) {
        spdlog::warn("{}", warning);
    }
    const bool floor_moved = loaded->config.floor != config_.floor;
    config_ = loaded->config;
    config_.fps = fps_.value_or(config_.fps);
    spdlog::set_level(spdlog::level::from_str(config_.log_level));
    log_failure(engine_.configure(config_.engine));
    for (const std::string& line : advice_on(config_.engine, config_.fps)) {
        spdlog::warn("{}: {}", utf8_from_path(profile_.config.filename()), line);
    }
    spdlog::info(
        "settings: {}, gravity {} px/s^2, restitution {}, {} frames/s",
        name_of(engine_.integrator()),
        config_.engine.physics.gravity,
        config_.engine.physics.restitution,
        config_.fps
    );
    pacer_.set_rate(config_.fps);
    if (floor_moved) {
        use_monitors();
    }
}

void Daemon::read_kinds() {
    LoadedKinds loaded = load_kinds(profile_, decode_);
    for (const std::string& problem : loaded.problems) {
        spdlog::error("{}", problem);
    }
    kind_problems_ = std::move(loaded.problems);
    // Frames point into the old sets: nobody may still show one.
    frame_ = {};
    desktop_.present(frame_);
    sets_ = std::move(loaded.sets);
    engine_.set_kinds(kinds_of(sets_));
}

void Daemon::read_scripts() {
    LoadedScripts loaded = load_scripts(profile_, config_.scripts);
    if (loaded.problems != script_problems_) {
        for (const std::string& problem : loaded.problems) {
            spdlog::error("{}", problem);
        }
        script_problems_ = std::move(loaded.problems);
    }
    if (loaded.sources != sources_) {
        sources_ = std::move(loaded.sources);
        scripts_.load(sources_);
    }
}

void Daemon::use_monitors() {
    std::vector<Monitor> monitors = desktop_.monitors();
    if (monitors.empty()) {
        // Screens go away for moments (lock, driver reset): keep the last ones.
        spdlog::warn("no monitor is known; keeping the arena as it was");
        return;
    }
    monitors_ = std::move(monitors);
    engine_.set_arena(Arena(monitors_, config_.floor));
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
    for (const std::vector<std::string>* list : {&kind_problems_, &script_problems_}) {
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
