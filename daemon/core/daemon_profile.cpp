// SPDX-License-Identifier: MIT
// What the daemon reads: config, sprite sets, scripts, monitors. What is broken changes nothing.
#include "daemon/core/config_advice.h"
#include "daemon/core/daemon.h"
#include "daemon/core/files.h"
#include "daemon/core/log_failure.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace hyrax {

/// True if something else holds from now on.
bool Daemon::read_config() {
    const Result<LoadedConfig> loaded = load_config(profile_.config);
    if (!loaded) {
        // The same broken text is told once, however often the file is touched.
        if (loaded.error().message != config_problem_) {
            spdlog::error("{}", loaded.error().message);
            spdlog::error("the settings stay as they were");
        }
        config_problem_ = loaded.error().message;
        return false;
    }
    config_problem_.clear();
    if (last_read_ == loaded->config) {
        return false;
    }
    last_read_ = loaded->config;
    for (const std::string& warning : loaded->warnings) {
        spdlog::warn("{}", warning);
    }
    if (loaded->config.limits != config_.limits) {
        // Scripts start again under them.
        scripts_.set_limits(loaded->config.limits);
        all_scripts_anew_ = true;
    }
    const bool places_moved =
        loaded->config.floor != config_.floor || loaded->config.allowed != config_.allowed;
    const bool ledges_changed = loaded->config.ledges != config_.ledges;
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
    use_presence_settings();
    desktop_.use_renderer(config_.renderer);
    keep_quiet();
    hotkeys_.use(desktop_, config_.hotkeys);
    if (places_moved) {
        use_monitors();
    }
    if (ledges_changed) {
        read_windows();
    }
    return true;
}

/// The user's and those of plugins. Taken before they are read: what is written meanwhile is read
/// once more.
std::string Daemon::stamp_of_sprites() const {
    return stamp_of_folder(profile_.user / "sprites") + "\n" + stamp_of_kinds(plugins_);
}

/// Files change at any time, and pets may be in the air: nobody waits for the pictures.
void Daemon::begin_reading_kinds(std::string stamp) {
    reading_aside_ = true;
    kinds_on_the_way_ = true;
    sprites_stamp_ = std::move(stamp);
    desktop_.read_aside(std::make_unique<SpriteReading>(profile_, plugins_, decode_));
}

void Daemon::on(const input::SpritesRead&) {
    const std::unique_ptr<SpriteReading> done = desktop_.sprites_read();
    if (done == nullptr) {
        return;
    }
    reading_aside_ = false;
    if (std::exchange(kinds_on_the_way_, false)) {
        use_kinds(done->take());
    }
    follow_files();
}

/// What the user asks for is done, and can be told, when this is.
void Daemon::read_kinds() {
    kinds_on_the_way_ = false;
    sprites_stamp_ = stamp_of_sprites();
    SpriteReading reading(profile_, plugins_, decode_);
    reading.run();
    use_kinds(reading.take());
}

void Daemon::use_kinds(Result<std::vector<ReadKind>> kinds) {
    if (!kinds) {
        spdlog::error("{}", kinds.error().message);
        kind_problems_ = {kinds.error().message};
        return;
    }
    // The first ones replace a placeholder, which is nothing to fall back on.
    std::vector<SpriteSet> before = std::exchange(sets_, {});
    if (edition_ == 0) {
        before.clear();
    }
    LoadedKinds loaded = completed(*std::move(kinds), std::move(before), profile_);
    for (const std::string& problem : loaded.problems) {
        spdlog::error("{}", problem);
    }
    kind_problems_ = std::move(loaded.problems);
    // Frames point into the old sets; what is seen of them is to be replaced, be it by nothing.
    frame_ = {};
    frame_lost_ = true;
    ++edition_;
    atlas_.clear();
    sets_ = std::move(loaded.sets);
    engine_.set_kinds(kinds_of(sets_));
}

/// A script may spawn a kind that has come with it: it waits for the pictures.
void Daemon::follow_files() {
    read_plugins();
    std::string stamp = stamp_of_sprites();
    const bool changed = stamp != sprites_stamp_;
    if (changed && !reading_aside_) {
        begin_reading_kinds(std::move(stamp));
    }
    if (!changed && !kinds_on_the_way_) {
        load_wanted_scripts();
    }
}

void Daemon::read_scripts() {
    read_plugins();
    if (kinds_on_the_way_ || stamp_of_sprites() != sprites_stamp_) {
        read_kinds();
    }
    load_wanted_scripts();
}

void Daemon::load_wanted_scripts() {
    LoadedScripts loaded = load_scripts(profile_, config_.scripts);
    if (loaded.problems != script_problems_) {
        for (const std::string& problem : loaded.problems) {
            spdlog::error("{}", problem);
        }
        script_problems_ = std::move(loaded.problems);
    }
    script_names_.clear();
    for (const ScriptSource& source : loaded.sources) {
        script_names_.push_back(source.name);
    }
    session_scripts_.adjust(loaded.sources, config_.developer);
    std::erase_if(loaded.sources, [this](const ScriptSource& source) {
        return remembered_.scripts_off.contains(source.name);
    });
    std::ranges::move(plugin_sources(), std::back_inserter(loaded.sources));
    if (std::exchange(all_scripts_anew_, false) || loaded.sources != sources_) {
        sources_ = std::move(loaded.sources);
        hotkeys_.keep(desktop_, sources_);
        std::vector<ScriptSource> with_stores = sources_;
        for (ScriptSource& source : with_stores) {
            source.store = stores_.of(source.name);
        }
        scripts_.load(std::move(with_stores));
    }
}

void Daemon::use_monitors() {
    std::vector<Monitor> monitors = desktop_.monitors();
    if (monitors.empty()) {
        // Screens go away for moments (lock, driver reset): keep the last ones.
        spdlog::warn("no monitor is known; keeping the arena as it was");
        return;
    }
    all_monitors_ = std::move(monitors);
    AllowedPlaces places = allowed_places(all_monitors_, config_.allowed, remembered_.monitors);
    if (!places.warning.empty() && places.warning != place_problem_) {
        spdlog::warn("{}", places.warning);
    }
    place_problem_ = std::move(places.warning);
    monitors_ = std::move(places.monitors);
    engine_.set_arena(Arena(monitors_, config_.floor));
    presence_.set_monitors(all_monitors_);
    read_windows();
}

}  // namespace hyrax
