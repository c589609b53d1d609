// SPDX-License-Identifier: MIT
// What the daemon reads: config, sprite sets, scripts, monitors. What is broken changes nothing.
#include "daemon/core/config_advice.h"
#include "daemon/core/daemon.h"
#include "daemon/core/files.h"
#include "daemon/core/log_failure.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

namespace hyrax {

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
    if (loaded->config.limits != config_.limits) {
        // Scripts start again under them.
        scripts_.set_limits(loaded->config.limits);
        sources_.clear();
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
    if (places_moved) {
        use_monitors();
    }
    if (ledges_changed) {
        read_windows();
    }
}

void Daemon::read_kinds() {
    // What is there before the first reading is a placeholder.
    const std::span<const SpriteSet> before =
        sprite_files_ ? std::span<const SpriteSet>(sets_) : std::span<const SpriteSet>();
    sprite_files_ = stamp_of_folder(profile_.user / "sprites");
    LoadedKinds loaded = load_kinds(profile_, decode_, before);
    add_plugin_kinds(loaded, plugins_, sets_, decode_);
    for (const std::string& problem : loaded.problems) {
        spdlog::error("{}", problem);
    }
    kind_problems_ = std::move(loaded.problems);
    // Frames point into the old sets.
    frame_ = {};
    ++edition_;
    atlas_.clear();
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
    script_names_.clear();
    for (const ScriptSource& source : loaded.sources) {
        script_names_.push_back(source.name);
    }
    session_scripts_.adjust(loaded.sources, config_.developer);
    std::erase_if(loaded.sources, [this](const ScriptSource& source) {
        return remembered_.scripts_off.contains(source.name);
    });
    std::ranges::move(read_plugins(), std::back_inserter(loaded.sources));
    if (loaded.sources != sources_) {
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
