// SPDX-License-Identifier: MIT
// The daemon's menus, and what single pets are asked through them.
#include "daemon/core/daemon.h"
#include "daemon/core/log_failure.h"

#include <vector>

namespace hyrax {

void Daemon::on(const input::MenuWanted& wanted) {
    MenuState state = menu_state();
    state.autostart = wanted.autostart;
    desktop_.show_menu(tray_menu(state), wanted.anchor);
}

MenuState Daemon::menu_state() {
    const WallTime wall = desktop_.wall_time();
    MenuState state{
        .pets = engine_.size(),
        .paused = paused_,
        .hidden = remembered_.hidden,
        .seconds_until_tomorrow = seconds_until_tomorrow(wall),
        .quiet = quiet(),
        .click_through = click_through(),
        .problem = problem(),
    };
    if (remembered_.hidden_until) {
        state.hidden_until = clock_text(wall, *remembered_.hidden_until);
    }
    for (const Kind& kind : engine_.kinds()) {
        if (!kind.name.contains('/')) {  // Those of plugins are for plugins.
            state.kinds.push_back(kind.name);
        }
    }
    for (const std::string& name : script_names_) {
        state.scripts.push_back({
            .name = name,
            .on = !remembered_.scripts_off.contains(name),
            .error = error_of(name),
        });
    }
    for (const PluginEntry& entry : plugins_) {
        state.plugins.push_back({
            .id = entry.id,
            .name = entry.plugin ? entry.plugin->name : entry.id,
            .on = entry.state == PluginState::on || entry.state == PluginState::asks,
            .asks = entry.state == PluginState::asks ? entry.missing : std::vector<std::string>{},
            .error = entry.problem.empty() ? error_of(entry.id) : entry.problem,
        });
    }
    for (std::size_t i = 0; i < all_monitors_.size(); ++i) {
        const Monitor& monitor = all_monitors_[i];
        state.monitors.push_back({
            .id = identity(monitor),
            .text = monitor_text(i + 1, monitor),
            .allowed = is_allowed(i),
        });
    }
    return state;
}

void Daemon::open_pet_menu(PetId id, Point at) {
    if (const Pet* const pet = engine_.find(id)) {
        const PetMenuState state{
            .pet = id,
            .scale = pet->scale,
            .others = engine_.size() - 1,
        };
        desktop_.show_menu(pet_menu(state), at);
    }
}

void Daemon::on(const input::Turned& turned) {
    const std::optional<PetId> id = pet_at(frame_, turned.at);
    const Pet* const pet = id ? engine_.find(*id) : nullptr;
    if (pet == nullptr) {
        return;
    }
    log_failure(engine_.set_scale(*id, scale_after(pet->scale, turned.steps)));
}

// The pet may have gone while its menu was open: that is no failure.
bool Daemon::is_there(PetId id) const {
    return engine_.find(id) != nullptr;
}

void Daemon::carry_out(const request::StopPet& stop) {
    if (is_there(stop.pet)) {
        log_failure(engine_.stop(stop.pet));
    }
}

void Daemon::carry_out(const request::ResetPet& reset) {
    if (is_there(reset.pet)) {
        log_failure(engine_.reset(reset.pet));
    }
}

void Daemon::carry_out(const request::SetScale& scale) {
    if (is_there(scale.pet)) {
        log_failure(engine_.set_scale(scale.pet, scale.scale));
    }
}

void Daemon::carry_out(const request::RemovePet& gone) {
    if (is_there(gone.pet)) {
        log_failure(engine_.remove(gone.pet));
    }
}

void Daemon::carry_out(const request::RemoveOthers& kept) {
    if (!is_there(kept.pet)) {
        return;
    }
    std::vector<PetId> others;
    engine_.for_each([&](PetId id, const Pet&) {
        if (id != kept.pet) {
            others.push_back(id);
        }
    });
    for (const PetId id : others) {
        log_failure(engine_.remove(id));
    }
}

}  // namespace hyrax
